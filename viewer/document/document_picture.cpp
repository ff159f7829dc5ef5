// SPDX-License-Identifier: Apache-2.0
// Documents that are pictures without a scene.
#include <utility>

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

Result<Done> Document::read_picture_again() {
    POL_TRY(auto picture, read_picture(picture_source_));
    show_read(std::move(picture));
    return Done{};
}

void Document::show_read(StokesImage picture) {
    read_origin_ = picture.origin;
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

void Document::keep_for_borrowers() {
    if (lent_->load(std::memory_order_acquire) == 0) return;
    picture_ = std::make_shared<StokesImage>(*picture_);
    lent_ = std::make_shared<std::atomic<int>>(0);
}

}  // namespace pol
