// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>

#include "core/contract.h"
#include "io/files/output_file.h"
#include "io/pictures/fits_format.h"
#include "io/pictures/form_writing.h"

namespace pol {

namespace {

class Header {
public:
    void add(std::string_view keyword, std::string_view value) {
        std::string card = fmt::format("{:<8}= {:>20}", keyword, value);
        card.resize(fits::card_size, ' ');
        text_ += card;
    }
    void add_text(std::string_view keyword, std::string_view value) {
        std::string quoted = "'";
        for (const char c : value) quoted += c == '\'' ? "''" : std::string(1, c);
        std::string card = fmt::format("{:<8}= {:<8}'", keyword, quoted);
        POL_EXPECTS(card.size() <= fits::card_size);
        card.resize(fits::card_size, ' ');
        text_ += card;
    }
    [[nodiscard]] std::string finished() const {
        std::string all = text_ + "END";
        const std::size_t blocks = (all.size() + fits::block_size - 1) / fits::block_size;
        all.resize(blocks * fits::block_size, ' ');
        return all;
    }

private:
    std::string text_;
};

/// What a card can hold: printable ASCII of limited length.
std::string card_text(std::string text) {
    constexpr std::size_t longest = 30;
    if (text.size() > longest) text.resize(longest);
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return text;
}

}  // namespace

Result<Done> write_fits(OutgoingPicture& picture, const std::filesystem::path& path) {
    const StokesImage& image = picture.image;
    const StokesComponents known = picture.known();
    const std::size_t components = known == StokesComponents::all()      ? 4
                                   : known == StokesComponents::linear() ? 3
                                   : known == StokesComponents::s0()     ? 1
                                                                         : 0;
    for (const Band& band : image.bands)
        if (band.known != known || components == 0)
            return cannot_hold("fits holds I, or I, Q and U, or all four, of every band", "choose another form");
    constexpr std::size_t most_bands = 9999;
    if (image.bands.size() > most_bands)
        return cannot_hold(fmt::format("fits holds {} bands at most", most_bands), "choose another form");

    Header header;
    header.add("SIMPLE", "T");
    header.add("BITPIX", "-64");
    header.add("NAXIS", "4");
    header.add("NAXIS1", std::to_string(image.width));
    header.add("NAXIS2", std::to_string(image.height));
    header.add("NAXIS3", std::to_string(components));
    header.add("NAXIS4", std::to_string(image.bands.size()));
    header.add_text("CTYPE3", "STOKES");
    for (const std::string axis : {"3", "4"})
        for (const std::string_view keyword : {"CRVAL", "CRPIX", "CDELT"})
            header.add(std::string(keyword) + axis, "1.0");
    header.add_text("CTYPE4", "BAND");
    header.add_text(fits::convention_keyword, picture.options.convention.text());
    for (std::size_t b = 0; b < image.bands.size(); ++b) {
        const std::string label = image.bands[b].label();
        const std::string held = card_text(label);
        if (held != label)
            picture.lost.push_back(fmt::format("The name of the band '{}' is cut to '{}'.", label, held));
        header.add_text(fmt::format("{}{}", fits::band_keyword, b + 1), held);
    }
    POL_TRY(auto file, OutputFile::create(path));
    const std::string begin = header.finished();
    file->write(begin.data(), begin.size());
    std::string row;
    std::uint64_t bytes = 0;
    for (std::size_t b = 0; b < image.bands.size(); ++b)
        for (std::size_t i = 0; i < components; ++i)
            for (int y = image.height; y-- > 0;) {  // the first row is the bottom one
                row.clear();
                for (int x = 0; x < image.width; ++x) {
                    const auto bits =
                        std::bit_cast<std::uint64_t>(picture.at(b, image.pixel(x, y)).*stokes_components[i]);
                    for (unsigned k = 8; k-- > 0;) row += static_cast<char>(bits >> 8U * k & 0xffU);
                }
                file->write(row.data(), row.size());
                bytes += row.size();
            }
    const std::string padding((fits::block_size - bytes % fits::block_size) % fits::block_size, '\0');
    file->write(padding.data(), padding.size());
    return file->commit();
}

}  // namespace pol
