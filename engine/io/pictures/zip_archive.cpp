// SPDX-License-Identifier: Apache-2.0
#include "io/pictures/zip_archive.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/pictures/picture_reading.h"

namespace pol {

namespace {

constexpr std::uint32_t local_signature = 0x04034b50;
constexpr std::uint32_t directory_signature = 0x02014b50;
constexpr std::uint32_t end_signature = 0x06054b50;
constexpr std::uint32_t end64_signature = 0x06064b50;
constexpr std::uint32_t end64_place_signature = 0x07064b50;
constexpr std::uint32_t in_64_bits = 0xffffffff;
constexpr std::uint16_t count_in_64_bits = 0xffff;
constexpr std::uint16_t extra_64_bits = 0x0001;
constexpr std::size_t local_size = 30;
constexpr std::size_t directory_size = 46;
constexpr std::size_t end_size = 22;
constexpr std::size_t end64_size = 56;
constexpr std::size_t end64_place_size = 20;
constexpr std::uint16_t stored = 0;
constexpr std::uint16_t deflated = 8;
constexpr std::uint64_t max_inflation = 1032;  ///< of zlib

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t i = count; i-- > 0;) number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
    return number;
}
std::uint16_t short_at(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint16_t>(number_at(bytes, at, 2));
}
std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint32_t>(number_at(bytes, at, 4));
}

/// `count` bytes of the file from `offset`; none if it is shorter.
std::optional<std::string> bytes_at(std::ifstream& file, std::uint64_t size, std::uint64_t offset,
                                    std::uint64_t count) {
    if (offset > size || count > size - offset) return std::nullopt;
    std::string bytes(static_cast<std::size_t>(count), '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(offset));
    if (!file.read(bytes.data(), static_cast<std::streamsize>(count))) return std::nullopt;
    return bytes;
}

Error damaged() {
    return input_error("is a damaged archive", "copy or save it again");
}

struct DirectoryPlace {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint64_t entries = 0;
};

/// From the record at the end, which a comment of up to 64 KiB may follow.
Result<DirectoryPlace> find_directory(std::ifstream& file, std::uint64_t size) {
    const std::uint64_t tail_size = std::min<std::uint64_t>(size, end_size + 0xffff);
    const auto tail = bytes_at(file, size, size - tail_size, tail_size);
    if (!tail || tail->size() < end_size) return damaged();
    std::size_t at = tail->size() - end_size;
    while (word_at(*tail, at) != end_signature) {
        if (at == 0) return damaged();
        --at;
    }
    DirectoryPlace place{word_at(*tail, at + 16), word_at(*tail, at + 12), short_at(*tail, at + 10)};
    if (short_at(*tail, at + 4) != 0 && short_at(*tail, at + 4) != count_in_64_bits)
        return input_error("is one of several volumes of an archive", "save it in one file");
    const std::uint64_t end_begins = size - tail_size + at;
    if (place.offset != in_64_bits && place.bytes != in_64_bits && place.entries != count_in_64_bits) return place;
    if (end_begins < end64_place_size) return place;
    const auto locator = bytes_at(file, size, end_begins - end64_place_size, end64_place_size);
    if (!locator || word_at(*locator, 0) != end64_place_signature) return place;
    const auto end64 = bytes_at(file, size, number_at(*locator, 8, 8), end64_size);
    if (!end64 || word_at(*end64, 0) != end64_signature) return damaged();
    return DirectoryPlace{number_at(*end64, 48, 8), number_at(*end64, 40, 8), number_at(*end64, 32, 8)};
}

/// Takes the sizes and the place that do not fit in 32 bits from the extra field.
bool read_64_bits(std::string_view extra, ZipEntry& entry, std::uint64_t& header_begins) {
    for (std::size_t at = 0; at + 4 <= extra.size();) {
        const std::size_t length = short_at(extra, at + 2);
        if (length > extra.size() - at - 4) return false;
        if (short_at(extra, at) == extra_64_bits) {
            std::string_view rest = extra.substr(at + 4, length);
            for (std::uint64_t* value : {&entry.unpacked, &entry.packed, &header_begins}) {
                if (*value != in_64_bits) continue;
                if (rest.size() < 8) return false;
                *value = number_at(rest, 0, 8);
                rest.remove_prefix(8);
            }
            return true;
        }
        at += 4 + length;
    }
    return true;
}

std::optional<Error> entry_problem(const ZipEntry& entry, std::uint16_t flags, std::uint64_t file_size) {
    const auto wrong = [&entry](std::string_view what, std::string hint) {
        return input_error(fmt::format("its entry '{}' {}", entry.name, what), std::move(hint));
    };
    if ((flags & 1U) != 0) return wrong("is encrypted", "save it with numpy.savez");
    if (entry.method != stored && entry.method != deflated)
        return wrong(fmt::format("is packed by method {}", entry.method), "numpy.savez and savez_compressed are read");
    const bool fits =
        entry.method == stored ? entry.packed == entry.unpacked : entry.unpacked / max_inflation <= entry.packed;
    if (!fits || entry.packed > file_size) return wrong("promises more than it can hold", "copy or save it again");
    return std::nullopt;
}

/// Inflates as it goes, and counts the checksum.
class EntryBytes : public ByteSource {
public:
    EntryBytes(const std::filesystem::path& path, const ZipEntry& entry)
        : packed_(path, entry.data_begins, entry.packed),
          is_deflated_(entry.method == deflated),
          left_(entry.unpacked),
          expected_(entry.checksum) {
        // Raw deflate: negative window bits.
        ready_ = !is_deflated_ || inflateInit2(&stream_, -MAX_WBITS) == Z_OK;
    }
    EntryBytes(const EntryBytes&) = delete;
    EntryBytes& operator=(const EntryBytes&) = delete;
    ~EntryBytes() override {
        if (is_deflated_) inflateEnd(&stream_);
    }

    bool read(char* target, std::size_t count) override {
        if (!ready_ || count > left_) return false;
        if (!(is_deflated_ ? inflate_to(target, count) : packed_.read(target, count))) return false;
        left_ -= count;
        for (std::size_t done = 0; done < count;) {
            const std::size_t part = std::min<std::size_t>(count - done, 1U << 30U);
            checksum_ = crc32(checksum_, reinterpret_cast<const Bytef*>(target) + done, static_cast<uInt>(part));
            done += part;
        }
        return left_ > 0 || checksum_ == expected_;
    }
    [[nodiscard]] std::uint64_t left() const override { return left_; }

private:
    bool inflate_to(char* target, std::size_t count) {
        while (count > 0) {
            if (stream_.avail_in == 0 && packed_.left() > 0) {
                const auto more = static_cast<std::size_t>(std::min<std::uint64_t>(packed_.left(), input_.size()));
                if (!packed_.read(input_.data(), more)) return false;
                stream_.next_in = reinterpret_cast<Bytef*>(input_.data());
                stream_.avail_in = static_cast<uInt>(more);
            }
            const std::size_t part = std::min<std::size_t>(count, 1U << 30U);
            stream_.next_out = reinterpret_cast<Bytef*>(target);
            stream_.avail_out = static_cast<uInt>(part);
            const uInt before_in = stream_.avail_in;
            const int status = inflate(&stream_, Z_NO_FLUSH);
            const std::size_t made = part - stream_.avail_out;
            target += made;
            count -= made;
            if (count > 0 && status != Z_OK) return false;
            if (made == 0 && before_in == stream_.avail_in && packed_.left() == 0 && count > 0) return false;
        }
        return true;
    }

    FileBytes packed_;
    bool is_deflated_;
    bool ready_ = false;
    std::uint64_t left_;
    uLong expected_;
    uLong checksum_ = 0;
    z_stream stream_{};
    std::array<char, 1U << 16U> input_{};
};

void append(std::string& bytes, std::uint64_t number, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(number >> 8U * i & 0xffU);
}

/// Fields that header and directory share, with sizes in the extra field.
void append_common(std::string& bytes, const ZipEntry& entry, std::size_t extra_size) {
    append(bytes, 45, 2);         // version needed: 64-bit sizes
    append(bytes, 1U << 11U, 2);  // names are UTF-8
    append(bytes, stored, 2);
    append(bytes, 0, 2);       // time
    append(bytes, 0x0021, 2);  // 1 January 1980: the same bytes every time
    append(bytes, entry.checksum, 4);
    append(bytes, in_64_bits, 4);
    append(bytes, in_64_bits, 4);
    append(bytes, entry.name.size(), 2);
    append(bytes, extra_size, 2);
}

std::string local_header(const ZipEntry& entry) {
    std::string bytes;
    append(bytes, local_signature, 4);
    append_common(bytes, entry, 20);
    bytes += entry.name;
    append(bytes, extra_64_bits, 2);
    append(bytes, 16, 2);
    append(bytes, entry.unpacked, 8);
    append(bytes, entry.packed, 8);
    return bytes;
}

}  // namespace

Result<std::vector<ZipEntry>> read_zip_directory(const std::filesystem::path& path) {
    std::error_code failed;
    const std::uint64_t size = std::filesystem::file_size(path, failed);
    std::ifstream file(path, std::ios::binary);
    if (failed || !file) return input_error("cannot be read", "check its permissions");
    POL_TRY(const DirectoryPlace place, find_directory(file, size));
    const auto directory = bytes_at(file, size, place.offset, place.bytes);
    if (!directory || place.entries > directory->size() / directory_size) return damaged();

    std::vector<ZipEntry> entries;
    std::set<std::string> names;
    std::string_view rest = *directory;
    for (std::uint64_t i = 0; i < place.entries; ++i) {
        if (rest.size() < directory_size || word_at(rest, 0) != directory_signature) return damaged();
        const std::size_t name_size = short_at(rest, 28);
        const std::size_t extra_size = short_at(rest, 30);
        const std::size_t all = directory_size + name_size + extra_size + short_at(rest, 32);
        if (all > rest.size()) return damaged();
        ZipEntry entry{std::string(rest.substr(directory_size, name_size)),
                       short_at(rest, 10),
                       word_at(rest, 16),
                       word_at(rest, 20),
                       word_at(rest, 24),
                       0};
        std::uint64_t header_begins = word_at(rest, 42);
        if (!read_64_bits(rest.substr(directory_size + name_size, extra_size), entry, header_begins)) return damaged();
        if (const auto problem = entry_problem(entry, short_at(rest, 8), size)) return *problem;
        const auto header = bytes_at(file, size, header_begins, local_size);
        if (!header || word_at(*header, 0) != local_signature) return damaged();
        entry.data_begins = header_begins + local_size + short_at(*header, 26) + short_at(*header, 28);
        if (entry.data_begins > size || entry.packed > size - entry.data_begins) return damaged();
        if (!names.insert(entry.name).second)
            return input_error(fmt::format("has two entries '{}'", entry.name), "save it again");
        entries.push_back(std::move(entry));
        rest.remove_prefix(all);
    }
    return entries;
}

std::unique_ptr<ByteSource> open_zip_entry(const std::filesystem::path& path, const ZipEntry& entry) {
    return std::make_unique<EntryBytes>(path, entry);
}

void ZipWriter::begin_entry(const std::string& name) {
    headers_.push_back(file_.position());
    entries_.push_back({name, stored, 0, 0, 0, 0});
    const std::string header = local_header(entries_.back());
    file_.write(header.data(), header.size());
}

void ZipWriter::write(const void* bytes, std::size_t count) {
    ZipEntry& entry = entries_.back();
    entry.checksum = static_cast<std::uint32_t>(crc32_z(entry.checksum, static_cast<const Bytef*>(bytes), count));
    entry.packed += count;
    entry.unpacked += count;
    file_.write(bytes, count);
}

void ZipWriter::end_entry() {
    const std::uint64_t end = file_.position();
    const std::string header = local_header(entries_.back());
    file_.seek(headers_.back());
    file_.write(header.data(), header.size());
    file_.seek(end);
}

void ZipWriter::finish() {
    const std::uint64_t begin = file_.position();
    std::string bytes;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const ZipEntry& entry = entries_[i];
        append(bytes, directory_signature, 4);
        append(bytes, 45, 2);  // version made by
        append_common(bytes, entry, 28);
        append(bytes, 0, 2);  // comment
        append(bytes, 0, 2);  // volume
        append(bytes, 0, 2);  // internal attributes
        append(bytes, 0, 4);  // external attributes
        append(bytes, in_64_bits, 4);
        bytes += entry.name;
        append(bytes, extra_64_bits, 2);
        append(bytes, 24, 2);
        append(bytes, entry.unpacked, 8);
        append(bytes, entry.packed, 8);
        append(bytes, headers_[i], 8);
    }
    const std::uint64_t directory_bytes = bytes.size();
    append(bytes, end64_signature, 4);
    append(bytes, end64_size - 12, 8);
    append(bytes, 45, 2);
    append(bytes, 45, 2);
    append(bytes, 0, 4);
    append(bytes, 0, 4);
    append(bytes, entries_.size(), 8);
    append(bytes, entries_.size(), 8);
    append(bytes, directory_bytes, 8);
    append(bytes, begin, 8);
    append(bytes, end64_place_signature, 4);
    append(bytes, 0, 4);
    append(bytes, begin + directory_bytes, 8);
    append(bytes, 1, 4);
    append(bytes, end_signature, 4);
    append(bytes, 0, 4);  // volumes
    append(bytes, count_in_64_bits, 2);
    append(bytes, count_in_64_bits, 2);
    append(bytes, in_64_bits, 4);
    append(bytes, in_64_bits, 4);
    append(bytes, 0, 2);  // comment
    file_.write(bytes.data(), bytes.size());
}

}  // namespace pol
