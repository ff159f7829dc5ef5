// SPDX-License-Identifier: Apache-2.0
#include "report/html_page.h"

#include <cstdint>
#include <span>
#include <string_view>

#include "io/pictures/png_file.h"
#include "report/plot_svg.h"

namespace pol {

namespace {

constexpr const char* page_style = R"(
body{font-family:sans-serif;margin:2em auto;max-width:1360px;padding:0 1em;line-height:1.45}
table{border-collapse:collapse}th,td{padding:.25em .6em;text-align:left;border-bottom:1px solid #8884}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.bad{color:#d22;font-weight:bold}.good{color:#1a8a3a;font-weight:bold}.soft{opacity:.75}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(560px,1fr));gap:1em}figure{margin:0}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(230px,1fr));gap:1em}
img{width:100%;image-rendering:pixelated}svg{width:100%;height:auto}
.bar{display:flex;width:18em;height:1.1em}.bar span{display:block;height:100%}
code{font-size:.95em;overflow-wrap:anywhere}
)";

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t block = 0;
        for (std::size_t j = 0; j < 3; ++j) block = block << 8U | (i + j < bytes.size() ? bytes[i + j] : 0U);
        const std::size_t known = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t j = 0; j < 4; ++j) out += j <= known ? digits[block >> (18U - 6U * j) & 63U] : '=';
    }
    return out;
}

}  // namespace

std::string html_page(const std::string& title, const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"color-scheme\" "
           "content=\"light dark\">\n<meta name=\"viewport\" content=\"width=device-width\"><title>" +
           xml_text(title) + "</title>\n<style>" + page_style + "</style></head><body>\n<h1>" + xml_text(title) +
           "</h1>\n" + body + "</body></html>\n";
}

std::string html_image(const RgbPicture& picture, const std::string& alt) {
    return "<img alt=\"" + xml_text(alt) + "\" src=\"data:image/png;base64," + base64(png_bytes(picture)) + "\">";
}

}  // namespace pol
