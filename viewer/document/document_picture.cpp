// SPDX-License-Identifier: Apache-2.0
// Documents that are pictures without a scene.
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "core/contract.h"
#include "core/result.h"
#include "viewer/document/document.h"

namespace pol {

std::unique_ptr<Document> Document::of_picture(StokesImage picture, std::string name) {
    std::unique_ptr<Document> document(new Document);
    document->name_ = std::move(name);
    document->show_read(std::move(picture));
    return document;
}

std::unique_ptr<Document> Document::of_file(const PictureSource& source, StokesImage picture,
                                            std::function<void()> wake) {
    std::unique_ptr<Document> document(new Document);
    document->picture_source_ = source;
    std::vector<std::filesystem::path> watched;
    const auto make_absolute = [&](std::filesystem::path& file) {
        std::error_code unknown_folder;
        file = std::filesystem::absolute(file, unknown_folder).lexically_normal();
        watched.push_back(file);
    };
    for (auto& file : document->picture_source_.files) make_absolute(file);
    for (auto& file : document->picture_source_.stokes_files)
        if (!file.empty()) make_absolute(file);
    document->path_ = document->picture_source_.path();
    document->name_ = document->path_.filename().string();
    document->watch_ = FileWatch(watched);
    document->wake_ = std::move(wake);
    document->show_read(std::move(picture));
    return document;
}

Result<Done> Document::reload_picture() {
    POL_TRY(auto header, read_picture_header(picture_source_));
    if (header.bytes > read_at_once_bytes) {
        reading_ = std::make_unique<PictureReading>(picture_source_, std::move(header), wake_);
        return Done{};
    }
    reading_.reset();
    POL_TRY(auto picture, read_picture(picture_source_));
    show_read(std::move(picture));
    return Done{};
}

void Document::take_reading() {
    if (!reading_) return;
    auto read = reading_->take();
    if (!read) return;
    const bool was_cancelled = reading_->cancelled();
    reading_.reset();
    if (*read)
        show_read(std::move(*read).value());
    else if (!was_cancelled)
        problem_ = read->error();
}

void Document::show_read(StokesImage picture) {
    read_origin_ = picture.origin;
    // One that does not tell what was left out has nothing that is not determined.
    if (!picture.residual.empty()) picture.peak = peaks_of(picture);
    show(std::make_shared<StokesImage>(std::move(picture)));
    if (chosen_convention_) take_numbers_for(chosen_convention_);
}

void Document::take_numbers_for(const std::optional<StokesConvention>& convention) {
    POL_EXPECTS(!has_scene());
    const StokesConvention wanted = convention.value_or(read_origin_.convention);
    chosen_convention_ = wanted == read_origin_.convention ? std::nullopt : std::optional(wanted);
    if (wanted == picture_->origin.convention) return;
    keep_for_borrowers();
    read_in(*picture_, wanted);
    picture_->origin.remarks = read_origin_.remarks;
    if (chosen_convention_)
        picture_->origin.remarks.push_back("The user took the numbers for: " + wanted.text() +
                                           "; the reader for: " + read_origin_.convention.text() + ".");
    changes_ = {whole_picture()};
    ++version_;
}

void Document::paint(const TileRect& rect, const std::function<void(StokesImage&)>& change) {
    POL_EXPECTS(!has_scene());
    keep_for_borrowers();
    change(*picture_);
    note_change(rect);
    painted_ = std::chrono::steady_clock::now();
}

void Document::describe(const std::function<void(StokesImage&)>& change) {
    const auto chosen = chosen_convention_;
    take_numbers_for(std::nullopt);
    keep_for_borrowers();
    change(*picture_);
    read_origin_ = picture_->origin;
    take_numbers_for(chosen);
    note_change(whole_picture());
}

bool Document::growing() const {
    return painted_ && std::chrono::steady_clock::now() - *painted_ < std::chrono::milliseconds(500);
}

void Document::keep_for_borrowers() {
    if (lent_->load(std::memory_order_acquire) == 0) return;
    picture_ = std::make_shared<StokesImage>(*picture_);
    lent_ = std::make_shared<std::atomic<int>>(0);
}

}  // namespace pol
