// SPDX-License-Identifier: Apache-2.0
#include "cli/ablation_report.h"
#include "cli/messages.h"
#include "report/number_words.h"

#include <gtest/gtest.h>

#include <string>

namespace pol {
namespace {

TEST(Report, DurationsReadAsPeopleSayThem) {
    EXPECT_EQ(duration_text(0.0123), "12 ms");
    EXPECT_EQ(duration_text(0.9996), "1.0 s");
    EXPECT_EQ(duration_text(5.34), "5.3 s");
    EXPECT_EQ(duration_text(9.96), "10 s");
    EXPECT_EQ(duration_text(59.4), "59 s");
    EXPECT_EQ(duration_text(59.6), "1 min 0 s");
    EXPECT_EQ(duration_text(130.2), "2 min 10 s");
    EXPECT_EQ(duration_text(3599.7), "1 h 0 min");
    EXPECT_EQ(duration_text(3.0 * 3600.0 + 5.0 * 60.0 + 59.0), "3 h 5 min");
}

TEST(Report, CountsReadAsPeopleSayThem) {
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(999'999), "999999");
    EXPECT_EQ(count_text(1'470'000), "1.47 million");
    EXPECT_EQ(count_text(2'300'000'000), "2.30 billion");
}

TEST(Report, TextOfAnyLanguageStaysAsItIs) {
    const std::string text = "Größe\n\xe5\x85\x89 \xf0\x9f\x92\x8e";
    EXPECT_EQ(printable(text), text);
}

// The table of well-formed sequences in RFC 3629: overlong forms, surrogates and what lies beyond U+10FFFF are none.
TEST(Report, BytesThatATerminalWouldObeyOrThatAreNoTextAreSpelledOut) {
    EXPECT_EQ(printable("\x1b[31m\r\x7f"), "\\x1b[31m\\x0d\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");  // the 8-bit form of ESC [
    EXPECT_EQ(printable("a\xff"
                        "b"),
              "a\\xffb");
    EXPECT_EQ(printable("\xc3"), "\\xc3");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");
    EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

// A defect of this program (README, "Exit codes").
TEST(Report, AFeatureThatChangesThePictureIsNamedAndEndsInExitCode1) {
    verify::AblationResult result;
    result.hash = 0x1234;
    for (const char* name : {"crystals (o and e rays)", "absorption along rays"}) {
        verify::AblationRow row;
        row.feature = name;
        row.hash = result.hash;
        row.holds = true;
        result.rows.push_back(row);
    }
    testing::internal::CaptureStderr();
    EXPECT_EQ(conclude(result), 0);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");

    result.rows[1].hash = 0x1235;
    result.rows[1].holds = false;
    testing::internal::CaptureStderr();
    EXPECT_EQ(conclude(result), 1);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "polariscope: defect: with 'absorption along rays' kept the picture is another one: 0000000000001235 "
              "instead of 0000000000001234\n");
    EXPECT_NE(ablation_text(result).find("OTHER BITS: 0000000000001235"), std::string::npos);
}

}  // namespace
}  // namespace pol
