// SPDX-License-Identifier: Apache-2.0
#include "viewer/widgets/fonts.h"

#include <fontconfig/fontconfig.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

namespace pol {

namespace {

struct Face {
    const char* style;
    const char* family;
    double size;  ///< points at scale 1
};

/// By FontRole.
constexpr std::array faces{Face{"Book", "DejaVu Sans", 14.0}, Face{"Bold", "DejaVu Sans", 14.0},
                           Face{"Book", "DejaVu Sans Mono", 13.0}, Face{"Bold", "DejaVu Sans", 26.0}};

/// Latin, Greek, punctuation with dashes and quotes, super- and subscripts, letterlike signs, arrows, mathematical
/// operators, box lines and geometric shapes. Pairs of first and last, ended by 0.
constexpr std::array<ImWchar, 17> ranges{0x0020, 0x017f, 0x0370, 0x03ff, 0x2010, 0x205f, 0x2070, 0x209f, 0x2100,
                                         0x214f, 0x2190, 0x21ff, 0x2200, 0x22ff, 0x2500, 0x25ff, 0};

/// File of an installed font, or empty: fontconfig offers its nearest match, which is good for nothing here.
std::string file_of(const Face& face) {
    const std::unique_ptr<FcPattern, void (*)(FcPattern*)> wanted(
        FcPatternBuild(nullptr, FC_FAMILY, FcTypeString, face.family, FC_STYLE, FcTypeString, face.style, nullptr),
        FcPatternDestroy);
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result{};
    const std::unique_ptr<FcPattern, void (*)(FcPattern*)> found(FcFontMatch(nullptr, wanted.get(), &result),
                                                                 FcPatternDestroy);
    FcChar8* family = nullptr;
    FcChar8* file = nullptr;
    if (!found || FcPatternGetString(found.get(), FC_FAMILY, 0, &family) != FcResultMatch ||
        FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch)
        return {};
    if (std::string(reinterpret_cast<const char*>(family)) != face.family) return {};
    return reinterpret_cast<const char*>(file);
}

}  // namespace

std::optional<std::string> load_fonts(double scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    std::optional<std::string> missing;
    for (const Face& face : faces) {
        const auto size = static_cast<float>(std::round(face.size * scale));
        const std::string file = file_of(face);
        if (!file.empty() && std::filesystem::exists(file) &&
            atlas.AddFontFromFileTTF(file.c_str(), size, nullptr, ranges.data()) != nullptr)
            continue;
        ImFontConfig fallback;
        fallback.SizePixels = size;
        atlas.AddFontDefault(&fallback);
        missing = std::string("the font ") + face.family +
                  " is not installed: Greek letters and subscripts show as '?'; install fonts-dejavu-core";
    }
    return missing;
}

ImFont* font(FontRole role) {
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    const int index = static_cast<int>(role);
    return index < fonts.Size ? fonts[index] : ImGui::GetFont();
}

}  // namespace pol
