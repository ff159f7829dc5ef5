// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ImfIO.h>

#include <stdexcept>
#include <string>

#include "io/files/output_file.h"

namespace pol::exr {

/// OpenEXR's view of an OutputFile. Throws, as OpenEXR wants it, when a write fails.
class OutputStream : public Imf::OStream {
public:
    OutputStream(OutputFile& file, const std::string& name) : Imf::OStream(name.c_str()), file_(file) {}

    void write(const char bytes[], int count) override {
        if (!file_.write(bytes, static_cast<std::size_t>(count))) throw std::runtime_error("write failed");
    }
    uint64_t tellp() override { return file_.position(); }
    void seekp(uint64_t position) override {
        if (!file_.seek(position)) throw std::runtime_error("seek failed");
    }

private:
    OutputFile& file_;
};

}  // namespace pol::exr
