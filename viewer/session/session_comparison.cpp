// SPDX-License-Identifier: Apache-2.0
// Pictures held against a reference: whether they can be, how that is shown, and where they differ most.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "compare/pairing.h"
#include "viewer/session/session.h"
#include "viewer/shown/picture_place.h"

namespace pol {

namespace {

Error refusal(std::string what, std::string remedy) {
    return Error{ErrorKind::usage, std::move(what), {}, {}, std::move(remedy)};
}

PixelAddress whole_size(const StokesImage& picture) {
    return {picture.whole_width > 0 ? picture.whole_width : picture.width,
            picture.whole_height > 0 ? picture.whole_height : picture.height};
}

/// How bad a pixel is: not a number is worse than what cannot be light, and that worse than any value.
struct Badness {
    int kind = 0;  // 0: nothing to say
    double size = 0.0;
    friend bool operator<(const Badness& a, const Badness& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.size < b.size;
    }
};

Badness badness(const MapPixel& pixel) {
    if (pixel.state == PixelState::not_a_number) return {3, 0.0};
    if (pixel.state == PixelState::unphysical) return {2, 0.0};
    if (pixel.state == PixelState::defined && pixel.value != 0.0) return {1, std::abs(pixel.value)};
    return {};
}

}  // namespace

void Session::set_reference() {
    if (current() == nullptr) return;
    reference_ = current();
    log_.add(Severity::note, reference_->name() + " is the reference; X shows how far other pictures are from it");
}

void Session::flip_to_reference() {
    const Document* from = current();
    if (reference_ == nullptr || from == reference_) return;
    show_document(reference_);
    flipped_from_ = from;
}

void Session::flip_back() {
    show_document(flipped_from_);
}

Result<Comparison> Session::compare() const {
    const Document* document = current();
    if (document == nullptr || reference_ == nullptr)
        return refusal("there is no reference to compare with",
                       "show the picture that others are to be compared with and press Shift+X");
    if (document == reference_)
        return refusal(document->name() + " is the reference itself", "PgDn and PgUp show the other pictures");
    const StokesImage& a = document->picture();
    const StokesImage& b = reference_->picture();
    if (const PixelAddress of_a = whole_size(a), of_b = whole_size(b); of_a != of_b)
        return refusal(fmt::format("{} has {} x {} pixels, the reference {} has {} x {}", document->name(), of_a.x,
                                   of_a.y, reference_->name(), of_b.x, of_b.y),
                       "compare pictures of one size, or parts of such");
    if (!compare::shared_area(a, b))
        return refusal(fmt::format("{} and the reference {} are parts of a picture that share no pixel",
                                   document->name(), reference_->name()),
                       "compare parts that overlap");
    const std::size_t band = std::min(view_.band, a.bands.size() - 1);
    if (const auto found = compare::comparable_band(a.bands, band, b.bands)) return Comparison{reference_, *found};
    return refusal(fmt::format("the reference {} has no band {}", reference_->name(), a.bands[band].label()),
                   "choose a band that both pictures have, or render them at the same wavelengths");
}

std::optional<Comparison> Session::comparison() const {
    const QuantityInfo& about = info(view_.quantity);
    if (about.quantity == Quantity::color || !(view_.difference || about.of_two)) return std::nullopt;
    const auto found = compare();
    return found ? std::optional(found.value()) : std::nullopt;
}

ShownQuantity Session::shown_quantity() const {
    std::optional<ReferencePicture> reference;
    if (const auto compared = comparison()) reference = compared->picture();
    return {current()->picture(), view_, polarimeter_, reference};
}

void Session::toggle_difference() {
    if (comparison()) {
        view_.difference = false;
        if (info(view_.quantity).of_two) view_.quantity = Quantity::dop;
    } else if (const auto possible = compare(); !possible) {
        log_.add(Severity::warning, to_string(possible.error()));
    } else {
        view_.difference = true;
        view_.layout = CompareLayout::single;
        if (view_.quantity == Quantity::color) show(Quantity::intensity);
    }
}

void Session::show(Quantity quantity) {
    view_.quantity = quantity;
    if (!info(quantity).of_two) return;
    view_.layout = CompareLayout::single;
    if (const auto possible = compare(); !possible && current() != nullptr)
        log_.add(Severity::warning, to_string(possible.error()));
}

CompareLayout Session::layout() const {
    return view_.layout != CompareLayout::single && compare() ? view_.layout : CompareLayout::single;
}

void Session::toggle_layout(CompareLayout wanted) {
    if (layout() == wanted) {
        view_.layout = CompareLayout::single;
    } else if (const auto possible = compare(); !possible) {
        log_.add(Severity::warning, to_string(possible.error()));
    } else {
        // Both pictures are seen as they are.
        if (comparison()) toggle_difference();
        view_.layout = wanted;
    }
}

std::optional<ShownSide> Session::side(PictureSide side) const {
    if (current() == nullptr) return std::nullopt;
    if (side == PictureSide::current) return ShownSide{current(), view_.band, comparison().has_value()};
    if (layout() == CompareLayout::single) return std::nullopt;
    const Comparison found = compare().value();
    return ShownSide{found.reference, found.band, false};
}

Result<ConventionAdvice> Session::convention_advice() const {
    const Document* document = current();
    if (document == nullptr || reference_ == nullptr || document == reference_) return compare().error();
    const StokesImage& ours = reference_->picture();
    const StokesImage& theirs = document->picture();
    POL_TRY(const auto pairing, compare::pair_up(ours, theirs));
    const compare::ConventionVerdict verdict = compare::diagnose(ours, theirs, pairing);
    const StokesConvention& current_one = theirs.origin.convention;
    ConventionAdvice advice{compare::sentence(verdict, current_one), compare::adoptable(verdict, current_one)};
    // The numbers of a render are what they are.
    if (document->has_scene()) advice.adopt.reset();
    return advice;
}

void Session::ask_doctor(bool adopt) {
    const auto advice = convention_advice();
    if (!advice) {
        log_.add(Severity::warning, to_string(advice.error()));
        return;
    }
    log_.add(Severity::note, current()->name() + " against " + reference_->name() + ": " + advice.value().verdict);
    if (!adopt) return;
    if (!advice.value().adopt) {
        log_.add(Severity::note, current()->has_scene() ? "a render has no other convention: take it for the reference"
                                                        : "there is nothing to take otherwise");
        return;
    }
    take_numbers_for(current(), advice.value().adopt);
    log_.add(Severity::note, "the numbers of " + current()->name() + " are now taken for " +
                                 current()->picture().origin.convention.text());
}

void Session::reveal(PixelAddress pixel) {
    const ViewTransform placed = of_part(transform_, corner_of(current()->picture()));
    const DVec2 at = placed.view_from_picture({pixel.x + 0.5, pixel.y + 0.5});
    const bool is_seen = at.x >= 0.0 && at.y >= 0.0 && at.x < view_size_.x && at.y < view_size_.y;
    if (!is_seen) transform_.pan(0.5 * view_size_ - at);
}

Result<Done> Session::go_to(const std::string& typed) {
    const auto usage = [&](std::string what) {
        return Error{ErrorKind::usage, std::move(what), {}, {}, "column and row from the top left, such as 12,7"};
    };
    if (current() == nullptr) return usage("nothing is open");
    int x = 0;
    int y = 0;
    const char* const end = typed.data() + typed.size();
    const auto skip = [end](const char* at, std::string_view what) {
        while (at != end && what.find(*at) != std::string_view::npos) ++at;
        return at;
    };
    const auto first = std::from_chars(skip(typed.data(), " "), end, x);
    const char* const between = first.ec == std::errc() ? skip(first.ptr, " ,") : end;
    const auto second = std::from_chars(between, end, y);
    if (first.ec != std::errc() || between == first.ptr || second.ec != std::errc() || skip(second.ptr, " ") != end)
        return usage("'" + typed + "' is no pixel");
    const StokesImage& picture = current()->picture();
    if (x < picture.left || y < picture.top || !has_pixel(picture, {x - picture.left, y - picture.top}))
        return usage(fmt::format("{} has no pixel {},{}: its columns are {} to {}, its rows {} to {}",
                                 current()->name(), x, y, picture.left, picture.left + picture.width - 1, picture.top,
                                 picture.top + picture.height - 1));
    const PixelAddress here{x - picture.left, y - picture.top};
    pin(here);
    reveal(here);
    return Done{};
}

void Session::pin_worst() {
    if (current() == nullptr) return;
    const bool is_difference = comparison().has_value();
    ViewSettings view = view_;
    if (!is_difference) view.quantity = Quantity::unphysical;
    const StokesImage& picture = current()->picture();
    const ShownQuantity quantity =
        is_difference ? shown_quantity() : ShownQuantity{picture, view, polarimeter_, std::nullopt};
    Badness worst;
    std::size_t at = 0;
    for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) {
        const Badness here = badness(quantity.at(pixel));
        if (!(worst < here)) continue;
        worst = here;
        at = pixel;
    }
    if (worst.kind == 0) {
        log_.add(Severity::note, is_difference ? "the pictures do not differ anywhere in this map"
                                               : "no pixel is unphysical or not a number in this band");
        return;
    }
    const auto width = static_cast<std::size_t>(picture.width);
    const PixelAddress here{static_cast<int>(at % width), static_cast<int>(at / width)};
    pin(here);
    reveal(here);
}

}  // namespace pol
