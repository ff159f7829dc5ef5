// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pol {

/// By the eight bytes of its signature.
bool is_png(std::string_view bytes);

/// A PNG picture from memory, in steps, so that its size can be judged before memory is taken. Every step returns false
/// after an error, of which message() speaks; no further step may follow then.
class PngReader {
public:
    enum class Color { as_stored, rgb };

    /// `bytes` must outlive it.
    explicit PngReader(std::string_view bytes);
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader();

    /// Reads up to the pixels; takes no memory that grows with the picture.
    bool read_header();
    /// True if the file is too short for its pixels: zlib never inflates by more than 1032:1.
    [[nodiscard]] bool promises_too_much() const;
    /// Asks for 8 or 16 bits a sample, palettes as colors; with Color::rgb for 3 or 4 channels, else for 1 to 4.
    bool prepare_rows(Color color);
    /// Requires: `pixels` has row_bytes * height bytes.
    bool read_rows(std::vector<std::uint8_t>& pixels);

    /// A sample of a row, in the machine's byte order, counted in samples.
    [[nodiscard]] std::size_t sample(const std::uint8_t* row, std::size_t index) const;
    /// What the file says under a keyword (tEXt, zTXt, iTXt) before its pixels; after read_header.
    [[nodiscard]] std::optional<std::string> text(std::string_view keyword) const;
    [[nodiscard]] std::string message() const;

    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint64_t stored_bits = 0;  ///< per pixel in the file
    bool says_srgb = false;         ///< has an sRGB chunk
    double gamma = 0.0;             ///< of the file's gAMA chunk; 0: there is none, or sRGB
    std::size_t channels = 0;
    std::size_t bytes_per_sample = 0;
    std::size_t row_bytes = 0;

private:
    struct Library;
    std::unique_ptr<Library> library_;
};

}  // namespace pol
