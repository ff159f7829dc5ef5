// SPDX-License-Identifier: Apache-2.0
// Small scenes and files for tests of the window's documents.
#pragma once

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "viewer/document/document.h"

namespace pol::test {

/// A folder of its own for one test, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "polariscope-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

/// The program runs in a temporary folder, where its exports go, until the end of the scope.
class WorkingFolder : public TemporaryFolder {
public:
    WorkingFolder() : home_(std::filesystem::current_path()) { std::filesystem::current_path(*this / "."); }
    ~WorkingFolder() { std::filesystem::current_path(home_); }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

private:
    std::filesystem::path home_;
};

inline void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

/// A glass plate before a lamp, seen at 45 degrees, two wavelengths.
inline std::string plate_scene(int width, int height, const std::string& index = "1.5") {
    return "camera: {position: [3, 0, 3], target: [0, 0, 0], fov: 20, up: [0, 1, 0]}\n"
           "render: {size: [" +
           std::to_string(width) + ", " + std::to_string(height) +
           "], wavelengths: [500, 600], residual: 1e-4}\n"
           "media:\n"
           "  glass: " +
           index +
           "\n"
           "objects:\n"
           "  - name: plate\n"
           "    shape: {box: {size: [2, 2, 0.2]}}\n"
           "    medium: glass\n"
           "  - name: lamp\n"
           "    shape: {rectangle: {size: 20}}\n"
           "    transform: [{translate: [0, 0, -5]}]\n"
           "    emission: {radiance: 1}\n";
}

/// Waits until the document's render has ended and its picture is all of it.
inline void finish(Document& document, double limit_s = 60.0) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
    while (!document.progress().finished) {
        if (std::chrono::steady_clock::now() > end) throw std::runtime_error("the render does not end");
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        document.update(10.0);
    }
}

}  // namespace pol::test
