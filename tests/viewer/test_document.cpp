// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "io/pictures/exr_file.h"
#include "io/scenes/pixel_case_file.h"
#include "io/scenes/scene_file.h"
#include "io/scenes/scene_hash.h"
#include "support/render_scene.h"
#include "viewer/document/document.h"
#include "viewer/viewer_files.h"

namespace pol {
namespace {

using test::TemporaryFolder;

std::unique_ptr<Document> opened(const std::filesystem::path& path) {
    auto document = Document::open(path, {});
    if (!document) throw std::runtime_error(to_string(document.error()));
    return std::move(document).value();
}

/// Looks at the file until the change is at rest.
bool file_changed(Document& document) {
    static double now_s = 0.0;
    for (int look = 0; look < 3; ++look)
        if (document.file_changed(now_s += 1.0)) return true;
    return false;
}

void expect_same_picture(const StokesImage& a, const StokesImage& b) {
    ASSERT_EQ(a.stokes.size(), b.stokes.size());
    EXPECT_TRUE(a.stokes == b.stokes);
    EXPECT_TRUE(a.residual == b.residual);
    EXPECT_TRUE(a.samples == b.samples);
}

TEST(Document, FollowsTheRenderToTheSamePictureAsWithoutAWindow) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(70, 50));
    const auto document = opened(folder / "plate.yaml");
    test::finish(*document);
    expect_same_picture(document->picture(), test::render(document->scene()));
}

/// A copy of the intensities that is brought up to date by what a document says has changed.
struct Follower {
    std::vector<Stokes<double>> copy;
    std::uint64_t version = 0;
    void follow(const Document& document) {
        const StokesImage& picture = document.picture();
        copy.resize(picture.stokes.size());
        for (const TileRect& rect : document.changes_since(version))
            for (std::size_t w = 0; w < picture.bands.size(); ++w)
                for (int y = rect.y0; y < rect.y1; ++y)
                    for (int x = rect.x0; x < rect.x1; ++x) {
                        const std::size_t at = w * picture.pixel_count() + picture.pixel(x, y);
                        copy[at] = picture.stokes[at];
                    }
        version = document.picture_version();
    }
};

TEST(Document, WhoeverKeepsACopyLearnsWhatChangedSince) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(70, 50));
    const auto document = opened(folder / "plate.yaml");
    Follower eager;
    Follower late;
    late.follow(*document);
    while (!document->progress().finished) {
        document->update(0.0);  // a tile at a time
        eager.follow(*document);
    }
    EXPECT_TRUE(eager.copy == document->picture().stokes);
    EXPECT_TRUE(document->changes_since(document->picture_version()).empty());
    EXPECT_GE(document->changes_since(late.version).size(), 20U) << "5 x 4 tiles, two readers";
    late.follow(*document);
    EXPECT_TRUE(late.copy == document->picture().stokes);
    // Another picture: all of it, whatever was seen before.
    ASSERT_TRUE(document->edit(document->scene(), "again"));
    ASSERT_EQ(document->changes_since(late.version).size(), 1U);
    EXPECT_EQ(document->changes_since(late.version)[0].pixel_count(), 3500);
}

// Under load the window takes tiles over later than they are finished.
TEST(Document, IsFinishedWhenAllOfThePictureIsShown) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(64, 48));
    const auto document = opened(folder / "plate.yaml");
    while (document->tracing()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    // Nothing is shown of what is finished.
    RenderProgress progress = document->progress();
    EXPECT_FALSE(progress.finished);
    EXPECT_EQ(progress.done, 0.0);
    EXPECT_EQ(progress.film.mean_samples, 0.0);
    // One of 4 x 3 tiles.
    EXPECT_TRUE(document->update(0.0));
    progress = document->progress();
    EXPECT_FALSE(progress.finished);
    EXPECT_DOUBLE_EQ(progress.done, 1.0 / 12.0);
    EXPECT_DOUBLE_EQ(progress.film.mean_samples, 1.0 / 12.0);
    while (document->update(0.0)) ASSERT_FALSE(document->progress().finished);
    progress = document->progress();
    EXPECT_TRUE(progress.finished);
    EXPECT_EQ(progress.done, 1.0);
    EXPECT_EQ(progress.film.fewest_samples, 1U);
    expect_same_picture(document->picture(), test::render(document->scene()));
}

// The bound beside the progress is that of the picture, summed as the film sums it.
TEST(Document, TheErrorsInTheStatusAreThoseOfTheWholeFilmOnceItIsShown) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(40, 30));
    const auto document = opened(folder / "plate.yaml");
    test::finish(*document);
    Renderer renderer(1, 16);
    renderer.start(document->plan());
    ASSERT_TRUE(renderer.wait_for(60.0));
    const FilmStatus film = renderer.progress().film;
    const FilmStatus shown = document->progress().film;
    EXPECT_GT(film.error.truncation, 0.0);
    EXPECT_EQ(shown.error.truncation, film.error.truncation);
    EXPECT_EQ(shown.error.residual_max, film.error.residual_max);
    EXPECT_EQ(shown.mean_samples, film.mean_samples);
}

TEST(Document, EditsUndoAndRedoGoThroughTheSameScenes) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    const auto document = opened(folder / "plate.yaml");
    std::vector<std::string> hashes{scene_hash(document->scene())};
    for (const double n : {1.6, 1.7, 1.8}) {
        Scene scene = document->scene();
        std::get<IsotropicMedium>(scene.media[0].matter).index = ConstantIndex{{n, 0.0}};
        ASSERT_TRUE(document->edit(std::move(scene), "index"));
        document->end_edit();
        hashes.push_back(scene_hash(document->scene()));
    }
    for (int step = 3; step-- > 0;) {
        ASSERT_TRUE(document->undo());
        EXPECT_EQ(scene_hash(document->scene()), hashes[static_cast<std::size_t>(step)]);
    }
    EXPECT_FALSE(document->dirty());
    for (std::size_t step = 1; step < hashes.size(); ++step) {
        ASSERT_TRUE(document->redo());
        EXPECT_EQ(scene_hash(document->scene()), hashes[step]);
    }
    EXPECT_TRUE(document->dirty());
    test::finish(*document);
    expect_same_picture(document->picture(), test::render(document->scene()));
}

void set_index(Document& document, double n) {
    Scene scene = document.scene();
    std::get<IsotropicMedium>(scene.media.at(0).matter).index = ConstantIndex{{n, 0.0}};
    ASSERT_TRUE(document.edit(std::move(scene), "index"));
}

// It decides what is dark, so hover, picture and exports must not each look for their own.
TEST(Document, KnowsTheBrightestPixelOfItsPictureHoweverItCame) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(40, 20));
    const auto document = opened(folder / "plate.yaml");
    for (const double n : {1.5, 2.5}) {
        ASSERT_NO_FATAL_FAILURE(set_index(*document, n));
        test::finish(*document);
        EXPECT_EQ(document->picture().peak, peaks_of(document->picture()));
        EXPECT_GT(document->picture().peak[0], 0.0);
    }
    StokesImage image = document->picture();
    image.peak.clear();
    EXPECT_EQ(Document::of_picture(image, "read")->picture().peak, document->picture().peak);
}

TEST(Document, ARefusedEditLeavesSceneAndPictureAlone) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    const auto document = opened(folder / "plate.yaml");
    test::finish(*document);
    const std::string hash = scene_hash(document->scene());
    const std::uint64_t version = document->picture_version();
    Scene scene = document->scene();
    std::get<IsotropicMedium>(scene.media[0].matter).index = ConstantIndex{{-1.0, 0.0}};
    EXPECT_FALSE(document->edit(std::move(scene), "index of glass"));
    ASSERT_TRUE(document->refused());
    EXPECT_EQ(document->refused()->label, "index of glass");
    EXPECT_EQ(document->refused()->error.field, "media.glass.index");
    EXPECT_EQ(scene_hash(document->scene()), hash);
    document->update(1.0);
    EXPECT_EQ(document->picture_version(), version);
    EXPECT_FALSE(document->dirty());
}

TEST(Document, ASavedSceneLoadsBackToTheSameHash) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    const auto document = opened(folder / "plate.yaml");
    Scene scene = document->scene();
    scene.media[0].matter = UniaxialMedium{ConstantIndex{{1.658, 0.0}}, ConstantIndex{{1.486, 0.0}}, {1.0, 0.3, 0.1}};
    scene.camera.position = {1.0 / 3.0, 2.0, 3.0};
    scene.render.depth = 7;
    ASSERT_TRUE(document->edit(std::move(scene), "all"));
    EXPECT_TRUE(document->dirty());
    ASSERT_TRUE(document->save(folder / "other.yaml"));
    EXPECT_FALSE(document->dirty());
    EXPECT_EQ(document->name(), "other.yaml");
    const auto loaded = load_scene(folder / "other.yaml");
    ASSERT_TRUE(loaded);
    EXPECT_EQ(scene_hash(loaded.value()), scene_hash(document->scene()));
    // Its own save is no change by another program.
    EXPECT_FALSE(file_changed(*document));
}

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The plate as people write it.
std::string commented_plate() {
    return "# Mine.\n" + test::plate_scene(8, 8, "1.50  # like N-BK7");
}

TEST(Document, SavingAHandWrittenSceneChangesWhatWasEditedAndNothingElse) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", commented_plate());
    const auto document = opened(folder / "plate.yaml");
    for (const char* n : {"1.6", "1.7"}) {
        ASSERT_NO_FATAL_FAILURE(set_index(*document, std::atof(n)));
        const auto saved = document->save(folder / "plate.yaml");
        ASSERT_TRUE(saved);
        EXPECT_EQ(saved.value(), Document::Saved::written);
        const std::string changed = "# Mine.\n" + test::plate_scene(8, 8, std::string(n) + "  # like N-BK7");
        EXPECT_EQ(content_of(folder / "plate.yaml"), changed);
    }
    // The same under another name.
    ASSERT_NO_FATAL_FAILURE(set_index(*document, 1.8));
    ASSERT_TRUE(document->save(folder / "other.yaml"));
    EXPECT_EQ(content_of(folder / "other.yaml"), "# Mine.\n" + test::plate_scene(8, 8, "1.8  # like N-BK7"));
    EXPECT_FALSE(std::filesystem::exists(folder / "plate.yaml.bak"));
    // What another program wrote is what is saved into from then on.
    test::write_text(folder / "other.yaml", "# Theirs.\n" + commented_plate());
    ASSERT_TRUE(document->reload());
    ASSERT_NO_FATAL_FAILURE(set_index(*document, 1.9));
    ASSERT_TRUE(document->save(folder / "other.yaml"));
    EXPECT_EQ(content_of(folder / "other.yaml"), "# Theirs.\n# Mine.\n" + test::plate_scene(8, 8, "1.9  # like N-BK7"));
}

TEST(Document, AFileThatCannotTakeAnEditIsWrittenAnewOnlyWithABackup) {
    const TemporaryFolder folder;
    // The edit is of what stands before and behind a comment.
    const std::string source =
        "# Mine.\n" + test::plate_scene(8, 8, "\n    # like N-BK7\n    {index: [1.5, # n\n      0.0]}");
    test::write_text(folder / "plate.yaml", source);
    const auto document = opened(folder / "plate.yaml");
    Scene scene = document->scene();
    scene.media[0].matter = UniaxialMedium{ConstantIndex{{1.6, 0.0}}, ConstantIndex{{1.5, 0.0}}, {1.0, 0.0, 0.0}};
    const std::string hash = scene_hash(scene);
    ASSERT_TRUE(document->edit(std::move(scene), "crystal"));
    const auto asked = document->save(folder / "plate.yaml");
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked.value(), Document::Saved::asks);
    EXPECT_EQ(content_of(folder / "plate.yaml"), source);
    EXPECT_TRUE(document->dirty());

    const auto saved = document->save(folder / "plate.yaml", Document::Rewrite::keep_backup);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved.value(), Document::Saved::written);
    EXPECT_EQ(content_of(folder / "plate.yaml.bak"), source);
    EXPECT_EQ(scene_hash(load_scene(folder / "plate.yaml").value()), hash);
    EXPECT_FALSE(document->dirty());

    // From now on there is nothing of the user's to lose.
    ASSERT_TRUE(document->undo());
    const auto again = document->save(folder / "plate.yaml");
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value(), Document::Saved::written);
    EXPECT_FALSE(std::filesystem::exists(folder / "plate.yaml.bak2"));
}

TEST(Document, WhatAnotherProgramWroteMeanwhileIsNotOverwrittenWithoutAWord) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", commented_plate());
    const auto document = opened(folder / "plate.yaml");
    ASSERT_NO_FATAL_FAILURE(set_index(*document, 1.6));
    test::write_text(folder / "plate.yaml", "half a sc");  // cannot be read
    EXPECT_FALSE(document->reload());
    const auto asked = document->save(folder / "plate.yaml");
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked.value(), Document::Saved::asks);
    EXPECT_EQ(content_of(folder / "plate.yaml"), "half a sc");
    test::write_text(folder / "plate.yaml.bak", "older");
    ASSERT_TRUE(document->save(folder / "plate.yaml", Document::Rewrite::keep_backup));
    EXPECT_EQ(content_of(folder / "plate.yaml.bak"), "older");
    EXPECT_EQ(content_of(folder / "plate.yaml.bak2"), "half a sc");
    EXPECT_EQ(content_of(folder / "plate.yaml"), "# Mine.\n" + test::plate_scene(8, 8, "1.6  # like N-BK7"));
    EXPECT_FALSE(document->problem());
}

TEST(Document, AnotherFileOfTheSameNameIsNotTakenForTheScenesOwn) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "elsewhere");
    const std::string card = "emission: {radiance: {texture: test-card.png}}  # ships with the program\n";
    const std::string plate = test::plate_scene(8, 8);
    test::write_text(folder / "plate.yaml", plate.substr(0, plate.find("emission")) + card);
    const auto document = opened(folder / "plate.yaml");
    ASSERT_TRUE(document->save(folder / "elsewhere/plate.yaml"));
    EXPECT_NE(content_of(folder / "elsewhere/plate.yaml").find(card), std::string::npos);
    test::write_text(folder / "test-card.png", "no picture");
    const auto saved = document->save(folder / "again.yaml");
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved.value(), Document::Saved::without_comments);
    const auto loaded = load_scene(folder / "again.yaml");
    ASSERT_TRUE(loaded);
    EXPECT_EQ(scene_hash(loaded.value()), scene_hash(document->scene()));
}

TEST(Document, NoticesAFileThatIsSavedInPlaceOrByRename) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    const auto document = opened(folder / "plate.yaml");
    EXPECT_FALSE(file_changed(*document));

    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8, "1.61"));
    EXPECT_TRUE(file_changed(*document));
    ASSERT_TRUE(document->reload());
    EXPECT_EQ(std::get<ConstantIndex>(std::get<IsotropicMedium>(document->scene().media[0].matter).index).value.n,
              1.61);
    EXPECT_FALSE(document->dirty());

    test::write_text(folder / "new", test::plate_scene(8, 8, "1.62"));
    std::filesystem::rename(folder / "new", folder / "plate.yaml");
    EXPECT_TRUE(file_changed(*document));
    ASSERT_TRUE(document->reload());
    EXPECT_EQ(std::get<ConstantIndex>(std::get<IsotropicMedium>(document->scene().media[0].matter).index).value.n,
              1.62);

    // Editors that move the old file away first leave a moment without any file.
    std::filesystem::rename(folder / "plate.yaml", folder / "plate.yaml~");
    EXPECT_FALSE(file_changed(*document));
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8, "1.63"));
    EXPECT_TRUE(file_changed(*document));
    EXPECT_FALSE(file_changed(*document));
}

TEST(Document, ABrokenFileIsExplainedAndTheOldPictureStays) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    const auto document = opened(folder / "plate.yaml");
    test::finish(*document);
    const StokesImage before = document->picture();
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8, "{indx: 1.5}"));
    ASSERT_TRUE(file_changed(*document));
    EXPECT_FALSE(document->reload());
    ASSERT_TRUE(document->problem());
    EXPECT_EQ(document->problem()->place.line, 4);
    EXPECT_GT(document->problem()->place.column, 0);
    document->update(1.0);
    expect_same_picture(document->picture(), before);

    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    ASSERT_TRUE(file_changed(*document));
    ASSERT_TRUE(document->reload());
    EXPECT_FALSE(document->problem());
}

TEST(Document, ReloadingCanBeUndoneSoThatNoEditIsLost) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    const auto document = opened(folder / "plate.yaml");
    Scene scene = document->scene();
    scene.camera.horizontal_fov *= 0.5;
    const std::string edited = scene_hash(scene);
    ASSERT_TRUE(document->edit(std::move(scene), "field of view"));
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8, "1.7"));
    ASSERT_TRUE(document->reload());
    EXPECT_FALSE(document->dirty());
    ASSERT_TRUE(document->undo());
    EXPECT_EQ(scene_hash(document->scene()), edited);
    EXPECT_TRUE(document->dirty());
}

TEST(Document, FollowsAnExrFileThatIsWrittenAgain) {
    const TemporaryFolder folder;
    StokesImage picture;
    picture.width = 3;
    picture.height = 2;
    picture.bands = bands_at({580.0});
    picture.stokes.assign(6, {1.0, 0.5, 0.0, 0.0});
    ASSERT_TRUE(write_exr(picture, folder / "a.exr"));
    const auto document = opened(folder / "a.exr");
    EXPECT_FALSE(document->has_scene());
    EXPECT_FALSE(document->dirty());
    picture.stokes.assign(6, {2.0, 0.5, 0.0, 0.0});
    ASSERT_TRUE(write_exr(picture, folder / "a.exr"));
    ASSERT_TRUE(file_changed(*document));
    ASSERT_TRUE(document->reload());
    EXPECT_EQ(document->picture().at(0, 5).s0, 2.0);
    test::write_text(folder / "a.exr", "no picture");
    ASSERT_TRUE(file_changed(*document));
    EXPECT_FALSE(document->reload());
    EXPECT_TRUE(document->problem());
    EXPECT_EQ(document->picture().at(0, 5).s0, 2.0);
}

// An export reads the picture in another thread: the picture must not change under it, and edits must not wait for it.
TEST(Document, ALentPictureStaysAsItIsWhileTheRenderGoesOn) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(64, 64));
    const auto document = opened(folder / "plate.yaml");
    auto lent = document->lend_picture();
    const StokesImage copy = *lent;
    while (document->tracing()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    document->update(1.0);
    expect_same_picture(*lent, copy);
    Scene scene = document->scene();
    scene.render.width = 32;
    ASSERT_TRUE(document->edit(std::move(scene), "size"));
    test::finish(*document);
    EXPECT_EQ(document->picture().width, 32);
    EXPECT_EQ(document->picture().samples[0], 1U);
    expect_same_picture(*lent, copy);

    auto again = document->lend_picture();
    again.reset();
    ASSERT_TRUE(document->undo());
    test::finish(*document);
    EXPECT_EQ(document->picture().samples[0], 1U);
}

TEST(Document, StopsByTimeAndGoesToTheEndWithoutTheRule) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(64, 64));
    const auto document = opened(folder / "plate.yaml");
    document->set_stop_rules({.seconds = 1e-6, .error = std::nullopt});
    test::finish(*document);
    EXPECT_EQ(document->progress().reason, StopReason::time);
    EXPECT_LT(document->progress().done, 1.0);
    document->set_stop_rules({});
    test::finish(*document);
    EXPECT_EQ(document->progress().reason, StopReason::samples);
    expect_same_picture(document->picture(), test::render(document->scene()));
}

TEST(Document, NoTwoDocumentsShareALayoutNumber) {
    const TemporaryFolder folder;
    test::write_text(folder / "plate.yaml", test::plate_scene(8, 8));
    const auto a = opened(folder / "plate.yaml");
    const auto b = opened(folder / "plate.yaml");
    EXPECT_NE(a->picture_layout(), b->picture_layout());
    const std::uint64_t layout = a->picture_layout();
    Scene scene = a->scene();
    scene.camera.horizontal_fov *= 0.5;
    ASSERT_TRUE(a->edit(scene, "fov"));
    EXPECT_EQ(a->picture_layout(), layout);
    scene.render.wavelengths_nm = {550.0};
    ASSERT_TRUE(a->edit(scene, "wavelengths"));
    EXPECT_NE(a->picture_layout(), layout);
}

/// A project folder with a scene in scenes/ that uses a mesh and a texture of the project and a texture that ships.
void write_project(const std::filesystem::path& project) {
    for (const char* folder : {"scenes", "meshes", "textures", "out"})
        std::filesystem::create_directories(project / folder);
    test::write_text(project / "meshes/tip.obj",
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    std::filesystem::copy_file(POL_ASSETS "/textures/test-card.png", project / "textures/own card.png");
    test::write_text(project / "scenes/scene.yaml",
                     "camera: {position: [0.2, 0.2, 5], target: [0.2, 0.2, 0], up: [0, 1, 0], fov: 30}\n"
                     "render: {size: [4, 4]}\nmedia: {glass: 1.5}\nobjects:\n"
                     "  - {name: tip, shape: {mesh: {file: ../meshes/tip.obj}}, medium: glass}\n"
                     "  - {name: own, shape: {rectangle: {size: 1}}, transform: [{translate: [0, 0, -1]}], emission: "
                     "{radiance: {texture: ../textures/own card.png}}}\n"
                     "  - {name: shipped, shape: {rectangle: {size: 3}}, transform: [{translate: [0, 0, -2]}], "
                     "emission: {radiance: {texture: test-card.png}}}\n");
}

/// What a project is after it was given away: nothing is left where it was.
std::filesystem::path moved(const std::filesystem::path& project) {
    const std::filesystem::path there = project.parent_path() / "given away";
    std::filesystem::rename(project, there);
    return there;
}

TEST(Document, SavesASceneThatMovesWithItsMeshesAndTextures) {
    const test::TemporaryFolder folder;
    const std::filesystem::path project = folder / "project";
    write_project(project);
    const auto document = opened(project / "scenes/scene.yaml");
    const std::string hash = scene_hash(document->scene());
    ASSERT_TRUE(document->save(project / "out/saved.yaml"));
    const std::string text = content_of(project / "out/saved.yaml");
    for (const char* name : {"\"../meshes/tip.obj\"", "\"../textures/own card.png\"", "texture: test-card.png"})
        EXPECT_NE(text.find(name), std::string::npos) << name << "\n" << text;
    const auto there = load_scene(moved(project) / "out/saved.yaml");
    ASSERT_TRUE(there) << to_string(there.error());
    EXPECT_EQ(scene_hash(there.value()), hash);
}

// A file of the user's own that has the name of one that ships is found first: the shipped one then needs its path.
TEST(Document, SavesTheShippedTextureEvenBesideAnotherOneOfItsName) {
    const test::TemporaryFolder folder;
    const std::filesystem::path project = folder / "project";
    write_project(project);
    const auto scene = load_scene(project / "scenes/scene.yaml");
    ASSERT_TRUE(scene);
    test::write_text(project / "out/test-card.png", "no picture");
    test::write_text(project / "out/saved.yaml", save_scene(scene.value(), project / "out"));
    const auto again = load_scene(project / "out/saved.yaml");
    ASSERT_TRUE(again) << to_string(again.error());
    EXPECT_EQ(scene_hash(again.value()), scene_hash(scene.value()));
}

// Behind a link, ".." leads out of the folder that it points to.
TEST(Document, SavesThroughALinkToAFolder) {
    const test::TemporaryFolder folder;
    const std::filesystem::path project = folder / "project";
    write_project(project);
    const auto scene = load_scene(project / "scenes/scene.yaml");
    ASSERT_TRUE(scene);
    std::filesystem::create_directories(folder / "deep/er/est");
    std::filesystem::create_directory_symlink(folder / "deep/er/est", project / "link");
    test::write_text(project / "link/saved.yaml", save_scene(scene.value(), project / "link"));
    const auto again = load_scene(project / "link/saved.yaml");
    ASSERT_TRUE(again) << to_string(again.error());
    EXPECT_EQ(scene_hash(again.value()), scene_hash(scene.value()));
}

TEST(PixelCase, MovesWithItsMeshesAndTextures) {
    const test::TemporaryFolder folder;
    const std::filesystem::path project = folder / "project";
    write_project(project);
    PixelCase pixel_case;
    pixel_case.wavelength_nm = 580.0;
    pixel_case.scene = load_scene(project / "scenes/scene.yaml").value();
    test::write_text(project / "out/pixel.case.yaml", save_pixel_case(pixel_case, project / "out"));
    EXPECT_EQ(content_of(project / "out/pixel.case.yaml").find(project.string()), std::string::npos);
    const auto there = load_pixel_case(moved(project) / "out/pixel.case.yaml");
    ASSERT_TRUE(there) << to_string(there.error());
    EXPECT_EQ(scene_hash(there.value().scene), scene_hash(pixel_case.scene));
}

}  // namespace
}  // namespace pol
