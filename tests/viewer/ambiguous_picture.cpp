// SPDX-License-Identifier: Apache-2.0
// Apart from the tests: OpenEXR declares a global name `half`, which ours would shadow.
#include "viewer/ambiguous_picture.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include <vector>

namespace pol::test {

void write_ambiguous_picture(const std::filesystem::path& path) {
    constexpr int side = 4;
    Imf::Header header(side, side);
    Imf::FrameBuffer buffer;
    std::vector<float> numbers(side * side, 1.0F);
    for (const char* name :
         {"S0", "S1", "S2", "S3", "S0.580,000000nm", "S1.580,000000nm", "S2.580,000000nm", "S3.580,000000nm"}) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        buffer.insert(
            name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers.data()), sizeof(float), side * sizeof(float)));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(side);
}

}  // namespace pol::test
