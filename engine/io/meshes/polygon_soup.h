// SPDX-License-Identifier: Apache-2.0
// What every mesh reader produces, and the bounded cursors that they read with.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "geometry/mesh.h"

namespace pol {

/// More would take many gigabytes and hours: surely a mistake.
constexpr std::size_t most_triangles = 10'000'000;

/// Polygons over shared vertices, as a file gives them: nothing checked but counts.
struct PolygonSoup {
    std::vector<DVec3> vertices;
    std::vector<std::uint32_t> corners;  ///< of all polygons, one after the other
    std::vector<std::uint32_t> last;     ///< per polygon: index into `corners` after its last corner
    std::vector<std::uint32_t> line;     ///< per polygon: its line in a text file; empty for binary files
};

/// The readers: `bytes` is the whole file. Errors lack the file name.
Result<PolygonSoup> read_obj(std::string_view bytes);
Result<PolygonSoup> read_ply(std::string_view bytes);
Result<PolygonSoup> read_stl(std::string_view bytes);
/// `folder`: where relative buffer names lead. .gltf and .glb are told apart by their first bytes.
Result<PolygonSoup> read_gltf(std::string_view bytes, const std::filesystem::path& folder);

/// An error at a line of a text file (0: unknown).
Error mesh_error(std::string what, int line, std::string hint);
/// An error at a byte of a binary file.
Error mesh_error_at_byte(const std::string& what, std::size_t offset, std::string hint);

/// `word` in quotes, cut to a length that a message can hold.
std::string quoted(std::string_view word);

/// Reads words and numbers from text and counts lines, which end in \n, \r\n or \r; never beyond the end. Steps over a
/// byte order mark at the beginning.
class TextCursor {
public:
    explicit TextCursor(std::string_view text, std::size_t at = 0, int line = 1) : text_(text), at_(at), line_(line) {
        if (at == 0 && text.starts_with("\ufeff")) at_ = 3;
    }

    int line() const { return line_; }
    std::size_t position() const { return at_; }
    bool at_end() const { return at_ >= text_.size(); }

    /// The rest of the current line without its end; moves to the next line.
    std::string_view take_line();
    /// The next word on any line; empty at the end.
    std::string_view take_word();

private:
    std::string_view text_;
    std::size_t at_;
    int line_;
};

/// First word of `line`, which is shortened by it; empty if there is none.
std::string_view take_word_of(std::string_view& line);
/// The whole of `word` as a finite number.
std::optional<double> finite_number(std::string_view word);
std::optional<std::int64_t> whole_number(std::string_view word);

/// One number of type T at `offset`, in the byte order of the file. Requires: offset + sizeof(T) <= bytes.size().
template <class T>
T number_at(std::string_view bytes, std::size_t offset, std::endian order) {
    std::array<char, sizeof(T)> raw;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        raw[order == std::endian::native ? i : sizeof(T) - 1 - i] = bytes[offset + i];
    }
    return std::bit_cast<T>(raw);
}

}  // namespace pol
