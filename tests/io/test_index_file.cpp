// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "io/files/assets.h"
#include "io/scenes/index_file.h"

namespace pol {
namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::random_device device;
        path_ = fs::temp_directory_path() / ("polariscope_index_" + std::to_string(device()));
        fs::create_directories(path_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() { fs::remove_all(path_); }

    [[nodiscard]] std::string write(const std::string& content, const std::string& name = "record.yml") const {
        const fs::path file = path_ / name;
        std::ofstream(file, std::ios::binary) << content;
        return file.string();
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

Result<RefractiveIndex> load_text(const std::string& content) {
    const TemporaryFolder folder;
    return load_index(folder.write(content), POL_ASSETS);
}

ComplexIndex shipped(const std::string& name, double nm) {
    const Result<RefractiveIndex> index = load_index(name, POL_ASSETS);
    EXPECT_TRUE(index) << name;
    const Result<ComplexIndex> value = index_at(index.value(), nm);
    EXPECT_TRUE(value) << name;
    return value.value();
}

// PHYSICS.md 3, computed there from the published coefficients; six decimals.
TEST(ShippedRecords, HaveTheIndicesOfTheLiterature) {
    const struct {
        const char* name;
        double n_589;
        double n_580;
    } table[] = {
        {"calcite-o", 1.658343, 1.658985},
        {"calcite-e", 1.486130, 1.486428},
        {"quartz-o", 1.544206, 1.544589},
        {"quartz-e", 1.553306, 1.553702},
        {"sapphire-o", 1.768076, 1.768598},
        {"sapphire-e", 1.760002, 1.760513},
        {"rutile-o", 2.612914, 2.620333},
        {"rutile-e", 2.908649, 2.918001},
        {"magnesium-fluoride-o", 1.377712, 1.377886},
        {"magnesium-fluoride-e", 1.389524, 1.389706},
        {"yttrium-vanadate-o", 1.999659, 2.001698},
        {"yttrium-vanadate-e", 2.226876, 2.229811},
        {"ktp-alpha", 1.767741, 1.769166},
        {"ktp-beta", 1.777546, 1.779096},
        {"ktp-gamma", 1.873367, 1.875491},
        {"n-bk7", 1.516728, 1.517122},
        {"n-sf10", 1.728055, 1.729268},
        {"fused-silica", 1.458403, 1.458735},
        {"diamond", 2.417259, 2.418497},
    };
    for (const auto& record : table) {
        EXPECT_NEAR(shipped(record.name, 589.3).n, record.n_589, 5.1e-7) << record.name;
        EXPECT_NEAR(shipped(record.name, 580.0).n, record.n_580, 5.1e-7) << record.name;
    }
    // Schott data sheet: nd = 1.78472, five decimals, at the helium d line. Daimon & Masumura table: 1.33334 at 589.3
    // nm, 20 C.
    EXPECT_NEAR(shipped("n-sf11", 587.5618).n, 1.78472, 5.1e-6);
    EXPECT_NEAR(shipped("water", 589.3).n, 1.3333, 1e-4);
}

// PHYSICS.md 3: linear between the tabulated points; three decimals.
TEST(ShippedRecords, HaveTheComplexIndicesOfTheMetals) {
    const struct {
        const char* name;
        ComplexIndex at_589;
        ComplexIndex at_580;
    } table[] = {
        {"gold", {0.273, 2.948}, {0.299, 2.837}},
        {"silver", {0.052, 3.919}, {0.051, 3.841}},
        {"aluminium", {1.207, 7.068}, {1.158, 6.965}},
    };
    for (const auto& record : table) {
        EXPECT_NEAR(shipped(record.name, 589.3).n, record.at_589.n, 5.1e-4) << record.name;
        EXPECT_NEAR(shipped(record.name, 589.3).k, record.at_589.k, 5.1e-4) << record.name;
        EXPECT_NEAR(shipped(record.name, 580.0).n, record.at_580.n, 5.1e-4) << record.name;
        EXPECT_NEAR(shipped(record.name, 580.0).k, record.at_580.k, 5.1e-4) << record.name;
    }
}

TEST(ShippedRecords, AllLoadAndHaveAnIndexAt580) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(POL_ASSETS) / "refractive_index")) {
        if (entry.path().extension() != ".yml") continue;
        ++count;
        const ComplexIndex index = shipped(entry.path().stem().string(), 580.0);
        EXPECT_GT(index.n, 0.0);
        EXPECT_GE(index.k, 0.0);
        EXPECT_TRUE(load_index(entry.path().string(), "nowhere"));  // by path, too
    }
    EXPECT_EQ(count, 24);
}

// The extinction of N-BK7 is tabulated beside its formula: 9.2541e-9 at 580 nm.
TEST(ShippedRecords, GlassHasTheExtinctionTabulatedBesideItsFormula) {
    EXPECT_NEAR(shipped("n-bk7", 580.0).k, 9.2541e-9, 1e-22);
}

TEST(ShippedRecords, DiamondEndsAt760NanometresExactly) {
    const RefractiveIndex diamond = load_index("diamond", POL_ASSETS).value();
    EXPECT_TRUE(index_at(diamond, 760.0));
    EXPECT_FALSE(index_at(diamond, 760.0001));
    EXPECT_NE(index_at(diamond, 780.0).error().what.find("'diamond', 226 to 760 nm"), std::string::npos);
}

TEST(IndexFile, MovesTheDecimalPointInsteadOfMultiplying) {
    // 1000 * 0.57 is 569.9999999999999 in doubles.
    const Result<RefractiveIndex> index =
        load_text("DATA:\n  - type: formula 5\n    wavelength_range: 1.1E-01 0.57\n    coefficients: 1.5\n");
    ASSERT_TRUE(index);
    EXPECT_TRUE(index_at(index.value(), 570.0));
    EXPECT_TRUE(index_at(index.value(), 110.0));
}

TEST(IndexFile, ReadsNAndKFromSeparateTables) {
    const Result<RefractiveIndex> index = load_text(
        "REFERENCES: |\n  somebody\nDATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.6 1.7\n"
        "  - type: tabulated k\n    data: |\n        0.5 1e-3\n        0.6 2E-3\nCONDITIONS:\n    - type: formula A\n");
    ASSERT_TRUE(index) << to_string(index.error());
    const ComplexIndex value = index_at(index.value(), 550.0).value();
    EXPECT_NEAR(value.n, 1.65, 1e-15);
    EXPECT_NEAR(value.k, 1.5e-3, 1e-18);
    EXPECT_EQ(index_at(index.value(), 400.0).value().k, 0.0);  // no k there
    EXPECT_TRUE(extinction_is_unknown(index.value(), 400.0));
}

// Order and repetition are no content of a table: halfway between 1.53 at 0.5 um and 1.52 at 0.6 um lies 1.525.
TEST(IndexFile, ReadsRowsInAnyOrderAndRepeatedOnes) {
    for (const char* rows : {"0.7 1.51 0.5\n        0.6 1.52 0.25\n        0.5 1.53 0.125\n",
                             "0.5 1.53 0.125\n        0.6 1.52 0.25\n        0.6 1.52 0.25\n        0.7 1.51 0.5\n",
                             "0.6 1.52 0.25\n        0.5 1.53 0.125\n        0.7 1.51 0.5\n        0.60 1.520 .25\n"}) {
        const auto index = load_text(std::string("DATA:\n  - type: tabulated nk\n    data: |\n        ") + rows);
        ASSERT_TRUE(index) << to_string(index.error());
        const ComplexIndex value = index_at(index.value(), 550.0).value();
        EXPECT_NEAR(value.n, 1.525, 1e-15);  // two roundings of numbers below 2
        EXPECT_EQ(value.k, 0.1875);
    }
}

TEST(IndexFile, OneRowIsAnIndexAtOneWavelength) {
    const auto index = load_text("DATA:\n  - type: tabulated nk\n    data: |\n        0.58 1.5 1e-3\n");
    ASSERT_TRUE(index);
    EXPECT_EQ(index_at(index.value(), 580.0).value(), (ComplexIndex{1.5, 1e-3}));
    EXPECT_FALSE(index_at(index.value(), 581.0));
}

TEST(IndexFile, AnOddRowSpoilsOnlyTheWavelengthsThatNeedIt) {
    const auto index = load_text(
        "DATA:\n  - type: tabulated nk\n    data: |\n        0.5 1.53 1e-6\n        0.6 1.52 5e-7\n"
        "        1.0 1.51 0\n        2.0 1.5 -3e-4\n");
    ASSERT_TRUE(index) << to_string(index.error());
    EXPECT_NEAR(index_at(index.value(), 580.0).value().n, 1.522, 1e-15);
    EXPECT_NEAR(index_at(index.value(), 580.0).value().k, 6e-7, 1e-21);
    const auto refused = index_at(index.value(), 1500.0);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().what.find("k = -3e-04 at 2000 nm"), std::string::npos) << refused.error().what;
}

// By hand, from the formulas of the database's documentation: five decimals.
TEST(IndexFile, ReadsTheRareFormulas) {
    const auto n = [](const char* type, const char* coefficients, double nm) {
        const auto index = load_text(std::string("DATA:\n  - type: ") + type +
                                     "\n    wavelength_range: 0.5 2.5\n    coefficients: " + coefficients + "\n");
        EXPECT_TRUE(index) << to_string(index.error());
        return index_at(index.value(), nm).value().n;
    };
    EXPECT_NEAR(n("formula 7", "3.41983 0.159906 -0.123109 1.26878e-6 -1.95104e-9", 1500.0), 3.46686, 5.1e-6);
    EXPECT_NEAR(n("formula 8", "0.45 0.097 0.091 -0.0021", 580.0), 2.27630, 5.1e-6);
    // n^2 = 2 + 0.1/(1 - 0.2) + 0.3 * 0.5/(0.5^2 + 0.35) = 2.375 at 1 um
    EXPECT_NEAR(n("formula 9", "2 0.1 0.2 0.3 0.5 0.35", 1000.0), std::sqrt(2.375), 1e-15);
}

TEST(IndexFile, TheNonlinearIndexIsNoPartOfN) {
    const std::string n2 = "  - type: tabulated n2\n    data: |\n        0.5 1e-20\n        0.6 1e-20\n";
    const auto both =
        load_text("DATA:\n" + n2 + "  - type: tabulated n\n    data: |\n        0.5 1.5\n        0.6 1.5\n");
    ASSERT_TRUE(both) << to_string(both.error());
    EXPECT_EQ(index_at(both.value(), 550.0).value(), (ComplexIndex{1.5, 0.0}));
    const auto alone = load_text("DATA:\n" + n2);
    ASSERT_FALSE(alone);
    EXPECT_EQ(alone.error().what, "has no refractive index n: it gives only n2");
}

TEST(IndexFile, AFurtherBlockIsForOtherWavelengths) {
    const auto index = load_text(
        "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 0.6\n    coefficients: 1.5\n"
        "  - type: tabulated nk\n    data: |\n        0.5 1.25 1\n        1.0 1.25 1\n"
        "  - type: tabulated k\n    data: |\n        2.0 3\n        3.0 3\n"
        "  - type: tabulated n\n    data: |\n        2.0 2\n        3.0 2\n");
    ASSERT_TRUE(index) << to_string(index.error());
    EXPECT_EQ(index_at(index.value(), 450.0).value(), (ComplexIndex{1.5, 0.0}));
    EXPECT_EQ(index_at(index.value(), 800.0).value(), (ComplexIndex{1.25, 1.0}));
    EXPECT_EQ(index_at(index.value(), 2500.0).value(), (ComplexIndex{2.0, 3.0}));
    EXPECT_FALSE(index_at(index.value(), 1500.0));
    const auto both = index_at(index.value(), 550.0);
    ASSERT_FALSE(both);
    EXPECT_NE(both.error().what.find("n = 1.5 in one block and 1.25 in another at 550 nm"), std::string::npos)
        << both.error().what;
}

const char* const record_of_1_6584 =
    "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.6584\n        0.7 1.6584\n";
const char* const record_of_1_4864 =
    "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.4864\n        0.7 1.4864\n";

TEST(Crystal, IsThePairOfFilesThatAPathStandsFor) {
    const TemporaryFolder folder;
    static_cast<void>(folder.write(record_of_1_6584, "spar-o.yml"));
    static_cast<void>(folder.write(record_of_1_4864, "spar-e.yml"));
    static_cast<void>(folder.write(record_of_1_6584, "spar.yml"));
    const std::string path = folder.path().string() + "/spar";
    EXPECT_TRUE(is_crystal(path, POL_ASSETS));
    const auto spar = load_crystal(path, POL_ASSETS);
    ASSERT_TRUE(spar) << to_string(spar.error());
    EXPECT_EQ(index_at(spar.value().ordinary, 580.0).value().n, 1.6584);
    EXPECT_EQ(index_at(spar.value().extraordinary, 580.0).value().n, 1.4864);
    const auto one_file = load_crystal(path + ".yml", POL_ASSETS);
    ASSERT_FALSE(one_file);
    EXPECT_NE(one_file.error().what.find("is one file, and a crystal has two indices"), std::string::npos);
    fs::remove(folder.path() / "spar-e.yml");
    const auto half = load_crystal(path, POL_ASSETS);
    ASSERT_FALSE(half);
    EXPECT_EQ(half.error().place.file, path + "-e.yml");
}

TEST(Crystal, OfThreeIndicesIsCalledBiaxial) {
    const auto shipped = load_crystal("ktp", POL_ASSETS);
    ASSERT_FALSE(shipped);
    EXPECT_EQ(shipped.error().what,
              "'ktp' is biaxial (it has ktp-alpha, ktp-beta, ktp-gamma); biaxial crystals are not supported");
    const TemporaryFolder folder;
    static_cast<void>(folder.write(record_of_1_6584, "topaz-gamma.yml"));
    const auto own = load_crystal(folder.path().string() + "/topaz", POL_ASSETS);
    ASSERT_FALSE(own);
    EXPECT_NE(own.error().what.find("is biaxial (it has topaz-gamma)"), std::string::npos) << own.error().what;
}

TEST(Crystal, IsNotOneIndex) {
    const auto calcite = load_index("calcite", POL_ASSETS);
    ASSERT_FALSE(calcite);
    EXPECT_EQ(calcite.error().what, "'calcite' is a crystal, not one index (it has calcite-o, calcite-e)");
    EXPECT_EQ(calcite.error().hint, "write {crystal: calcite}");
    EXPECT_NE(load_index("ktp", POL_ASSETS).error().hint.find("biaxial"), std::string::npos);
}

TEST(Crystal, AnUnknownNameSuggestsTheNearestCrystal) {
    const auto unknown = load_crystal("calcit", POL_ASSETS);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().what, "there is no crystal 'calcit'");
    EXPECT_EQ(unknown.error().hint, "did you mean 'calcite'?");
    EXPECT_NE(load_crystal("kryptonite", POL_ASSETS).error().hint.find("calcite, magnesium-fluoride"),
              std::string::npos);
}

TEST(IndexFile, ReadsWindowsLineEndsTabsInTablesAndByteOrderMarks) {
    EXPECT_TRUE(
        load_text("\xef\xbb\xbf"
                  "DATA:\r\n  - type: tabulated n\r\n    data: |\r\n        0.4\t1.5\r\n        0.6 +1.7\r\n"));
}

TEST(IndexFile, AnUnknownNameSuggestsTheNearestRecord) {
    const Result<RefractiveIndex> index = load_index("calcit-o", POL_ASSETS);
    ASSERT_FALSE(index);
    EXPECT_EQ(index.error().what, "there is no index record 'calcit-o'");
    EXPECT_EQ(index.error().hint, "did you mean 'calcite-o'?");
    EXPECT_NE(load_index("kryptonite", POL_ASSETS).error().hint.find("gold, ktp-alpha"), std::string::npos);
}

TEST(IndexFile, AMissingFileAFolderAndAnEmptyFileAreErrors) {
    const TemporaryFolder folder;
    EXPECT_EQ(load_index("nowhere/glass.yml", POL_ASSETS).error().place.file, "nowhere/glass.yml");
    EXPECT_EQ(load_index(folder.path().string(), POL_ASSETS).error().what, "is a folder");
    EXPECT_EQ(load_text("").error().what, "is empty");
    EXPECT_EQ(load_text("\n \n").error().what, "is empty");
    EXPECT_EQ(load_index("/dev/null", POL_ASSETS).error().what, "is not a regular file");
}

TEST(IndexFile, AHugeFileIsRefusedUnread) {
    const TemporaryFolder folder;
    const std::string file = folder.write("DATA:\n");
    fs::resize_file(file, std::uintmax_t{1} << 33u);  // sparse
    const Result<RefractiveIndex> index = load_index(file, POL_ASSETS);
    ASSERT_FALSE(index);
    EXPECT_NE(index.error().what.find("more than the limit"), std::string::npos);
}

struct BadRecord {
    const char* text;
    int line;
    int column;
    const char* field;
    const char* what;
};

TEST(IndexFile, MalformedRecordsAreErrorsWithAnAddress) {
    const BadRecord bad[] = {
        {"just words", 1, 1, "", "not an index record"},
        {"a: b: c\n", 1, 5, "", "not valid YAML"},
        {"DATA:\n\t- type: formula 1\n", 2, 1, "", "indented with a tab"},
        {"COMMENTS: hi\n", 1, 1, "DATA", "missing"},
        {"A: 1\nDATA: []\nDATA: []\n", 3, 1, "DATA", "occurs twice"},
        {"DATA:\n  - type: tabulated n\n    data: 0.4 1.5\n    data: 0.4 2.5\n", 4, 5, "DATA[0].data", "occurs twice"},
        {"A: 1\nDATA: 3\n", 2, 7, "DATA", "not a list"},
        {"DATA: []\n", 1, 7, "DATA", "not a list"},
        {"DATA:\n  - 5\n", 2, 5, "DATA[0]", "not a map"},
        {"DATA:\n  - data: 5\n", 2, 5, "DATA[0].type", "missing"},
        {"DATA:\n  - type: formula 10\n", 2, 11, "DATA[0].type", "unknown type 'formula 10'"},
        {"DATA:\n  - type: formula 8\n    wavelength_range: 0.3 2\n    coefficients: 0 1 2 3 4\n", 4, 19,
         "DATA[0].coefficients", "5 coefficients"},
        {"DATA:\n  - type: formula A\n", 2, 11, "DATA[0].type", "unknown type"},
        {"DATA:\n  - type: [1]\n", 2, 11, "DATA[0].type", "not plain text"},
        {"DATA:\n  - type: formula 1\n    coefficients: 1\n", 2, 5, "DATA[0].wavelength_range", "missing"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3\n", 3, 23, "DATA[0].wavelength_range",
         "not two numbers"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3 0.3\n", 3, 27, "DATA[0].wavelength_range",
         "range is empty"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0 0.3\n", 3, 23, "DATA[0].wavelength_range",
         "not a wavelength"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2\n", 2, 5, "DATA[0].coefficients", "missing"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2\n    coefficients: 0 1\n", 4, 19,
         "DATA[0].coefficients", "2 coefficients"},
        {"DATA:\n  - type: formula 4\n    wavelength_range: 0.3 2\n    coefficients: 0 1 2\n", 4, 19,
         "DATA[0].coefficients", "3 coefficients"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2\n    coefficients: 0 1 x2\n", 4, 23,
         "DATA[0].coefficients", "not a finite number: x2"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2\n    coefficients: nan\n", 4, 19,
         "DATA[0].coefficients", "not a finite number"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3 inf\n    coefficients: 1\n", 3, 27,
         "DATA[0].wavelength_range", "not a finite number"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 0.3 2\n    coefficients: 1e999\n", 4, 19,
         "DATA[0].coefficients", "not a finite number"},
        {"DATA:\n  - type: tabulated n\n", 2, 5, "DATA[0].data", "missing"},
        {"DATA:\n  - type: tabulated n\n    data: |\n\n", 3, 11, "DATA[0].data", "no rows"},
        {"DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 1.5 2\n", 5, 9, "DATA[0].data",
         "3 numbers"},
        {"DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5\n        0.5 1.5\n", 4, 9, "DATA[0].data",
         "2 numbers"},
        {"DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 1.5a\n", 5, 13, "DATA[0].data",
         "not a finite"},
        {"DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        -0.5 1.5\n", 5, 9, "DATA[0].data",
         "not a wavelength"},
        {"DATA:\n  - type: tabulated k\n    data: |\n        0.4 1.5\n        0.5 1.5\n", 2, 3, "DATA",
         "has no refractive index n: it gives only k"},
    };
    for (const BadRecord& record : bad) {
        SCOPED_TRACE(record.text);
        const Result<RefractiveIndex> index = load_text(record.text);
        ASSERT_FALSE(index);
        const Error& error = index.error();
        EXPECT_EQ(error.kind, ErrorKind::input);
        EXPECT_EQ(error.place.line, record.line);
        EXPECT_EQ(error.place.column, record.column);
        EXPECT_EQ(error.field, record.field);
        EXPECT_NE(error.what.find(record.what), std::string::npos) << error.what;
        EXPECT_FALSE(error.hint.empty());
        EXPECT_FALSE(error.place.file.empty());
    }
}

TEST(IndexFile, ACommentBehindTheBarOfABlockIsNoRow) {
    const auto index =
        load_text("DATA:\n  - type: tabulated n\n    data: | # 0.5 to 0.7 um\n        0.5 1.5\n        0.7 1.7\n");
    ASSERT_TRUE(index) << to_string(index.error());
    EXPECT_NEAR(index_at(index.value(), 600.0).value().n, 1.6, 1e-14);
}

// Damage at random: whatever comes out is a result, never a crash, and a record that still loads has sound numbers.
TEST(IndexFile, SurvivesRandomDamage) {
    std::ifstream stream(fs::path(POL_ASSETS) / "refractive_index" / "n-bk7.yml");
    std::stringstream buffer;
    buffer << stream.rdbuf();
    const std::string original = buffer.str();
    ASSERT_GT(original.size(), 500u);
    std::mt19937 random(7);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const TemporaryFolder folder;
    int refused = 0;
    for (int i = 0; i < 800; ++i) {
        std::string text = original;
        for (std::size_t edits = 1 + pick(4); edits > 0; --edits) {
            const std::size_t at = pick(text.size());
            switch (pick(4)) {
                case 0:
                    text[at] = static_cast<char>(random());
                    break;
                case 1:
                    text.erase(at, 1 + pick(20));
                    break;
                case 2:
                    text.insert(at, 1 + pick(3), "\n:-[]{}&*!|>'\"%@`, 0e\t"[pick(23)]);
                    break;
                default:
                    text.resize(at + 1);
                    break;
            }
        }
        const Result<RefractiveIndex> index = load_index(folder.write(text), POL_ASSETS);
        if (!index) {
            ++refused;
            EXPECT_FALSE(index.error().what.empty());
        } else if (const Result<ComplexIndex> value = index_at(index.value(), 580.0)) {
            EXPECT_TRUE(value.value().n > 0.0 && value.value().k >= 0.0);
        }
    }
    EXPECT_GT(refused, 80);
}

TEST(Assets, AreFoundThroughTheEnvironmentElseBesideTheProgram) {
    ASSERT_EQ(setenv("POLARISCOPE_ASSETS", "somewhere", 1), 0);
    EXPECT_EQ(assets_dir(), fs::path("somewhere"));
    ASSERT_EQ(unsetenv("POLARISCOPE_ASSETS"), 0);
    EXPECT_TRUE(fs::equivalent(assets_dir(), POL_ASSETS));
}

}  // namespace
}  // namespace pol
