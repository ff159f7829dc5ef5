// SPDX-License-Identifier: Apache-2.0
#include "viewer/session/exports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "core/result.h"
#include "core/units.h"
#include "io/files/output_file.h"
#include "io/live/live_sender.h"
#include "io/pictures/exr_file.h"
#include "io/pictures/png_file.h"
#include "io/scenes/picture_attributes.h"
#include "maps/color_picture.h"
#include "polarization/measures.h"
#include "report/map_picture.h"
#include "viewer/session/map_look.h"
#include "viewer/shown/shown_picture.h"
#include "viewer/shown/shown_quantity.h"

namespace pol {

namespace {

namespace fs = std::filesystem;

std::string stem_of(const Document& document) {
    return fs::path(document.name()).stem().string();
}

/// What only a preview says is not known.
void forget_preview(StokesImage& image) {
    const std::size_t pixels = image.pixel_count();
    const auto fill = [&](auto& planes, std::size_t pixel, const auto& value) {
        for (std::size_t i = pixel; i < planes.size(); i += pixels) planes[i] = value;
    };
    for (std::size_t pixel = 0; pixel < image.samples.size(); ++pixel) {
        if (image.samples[pixel] > 0) continue;
        fill(image.stokes, pixel, Stokes<double>{});
        fill(image.residual, pixel, 1.0);
        fill(image.tail, pixel, 0.0);
    }
}

/// The picture behind the polarimeter, labeled in a convention; of one band if that is all that the map needs.
StokesImage seen_behind(const StokesImage& picture, const Polarimeter& polarimeter, const Convention& convention,
                        std::optional<std::size_t> band) {
    StokesImage seen;
    seen.width = picture.width;
    seen.height = picture.height;
    seen.stored = picture.stored;
    const std::size_t pixels = picture.pixel_count();
    const std::size_t first = band.value_or(0);
    const std::size_t last = band ? first + 1 : picture.bands.size();
    const auto part = [&](const auto& planes) {
        if (planes.size() <= pixels) return planes;
        return std::decay_t<decltype(planes)>(planes.begin() + static_cast<std::ptrdiff_t>(first * pixels),
                                              planes.begin() + static_cast<std::ptrdiff_t>(last * pixels));
    };
    seen.stokes = part(picture.stokes);
    seen.residual = part(picture.residual);
    seen.tail = part(picture.tail);
    for (std::size_t w = first; w < last; ++w) {
        seen.bands.push_back(picture.bands[w]);
        if (!picture.brightest.empty()) seen.brightest.push_back(picture.brightest[w]);
        if (!picture.peak.empty()) seen.peak.push_back(picture.peak[w]);
    }
    if (polarimeter.empty() && convention == Convention{}) return seen;
    const ShownPicture shown(picture, polarimeter, convention);
    for (std::size_t w = first; w < last; ++w) seen.bands[w - first].known = shown.known(w);
    for (std::size_t w = first; w < last; ++w)
        for (std::size_t pixel = 0; pixel < pixels; ++pixel)
            seen.stokes[(w - first) * pixels + pixel] = shown.stokes(w, pixel);
    return seen;
}

/// The map's color times the picture's lightness, as the window shows it.
void lay_over_intensity(RgbPicture& shown, const StokesImage& seen, const MapOptions& options) {
    const std::vector<Rgb> colors = color_picture(seen);
    const double gain = std::exp2(options.exposure);
    for (std::size_t pixel = 0; pixel < colors.size(); ++pixel) {
        const auto light = [&](std::size_t c) { return developed(gain * colors[pixel][c], options); };
        const double luminance = 0.2126 * light(0) + 0.7152 * light(1) + 0.0722 * light(2);
        const double lightness = srgb_encode(std::clamp(luminance, 0.0, 1.0));
        for (std::uint8_t& channel : shown.pixels[pixel])
            channel = static_cast<std::uint8_t>(std::lround(channel * lightness));
    }
}

/// What a picture is held against, for another thread.
struct LentReference {
    std::shared_ptr<const StokesImage> picture;
    std::size_t band = 0;
};

Map difference_map(const StokesImage& picture, const ViewSettings& view, const Polarimeter& polarimeter,
                   const LentReference& reference) {
    const ShownQuantity shown(picture, view, polarimeter, ReferencePicture{reference.picture.get(), reference.band});
    Map map{view.quantity, picture.bands[view.band], true, picture.width, picture.height, {}};
    map.pixels.reserve(picture.pixel_count());
    for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) map.pixels.push_back(shown.at(pixel));
    return map;
}

/// `reference`: minus that of this one.
Result<Done> write_map(const StokesImage& picture, const ViewSettings& view, const MapOptions& options,
                       const Polarimeter& polarimeter, const std::optional<LentReference>& reference,
                       const std::string& caption, const fs::path& path, ExportProgress& progress) {
    const bool is_color = view.quantity == Quantity::color;
    const bool needs_all = is_color || view.over_intensity;
    const StokesImage seen =
        seen_behind(picture, polarimeter, view.convention, needs_all ? std::nullopt : std::optional(view.band));
    progress = 0.2;
    POL_TRY(auto map,
            reference ? Result<ColoredMap>(colorize(difference_map(picture, view, polarimeter, *reference), options))
                      : draw_map(seen, view.quantity, needs_all ? view.band : 0, options));
    if (view.over_intensity && !is_color) lay_over_intensity(map.picture, seen, options);
    progress = 0.5;
    POL_TRY(const auto drawn, map_picture(map, caption));
    progress = 0.8;
    return write_png(drawn, path);
}

/// Which pixels are meant: those that are marked, else those of the region; empty: all.
std::vector<bool> wanted_pixels(const Selection& selection, const StokesImage& picture) {
    if (!selection.marked.empty() || !selection.region) return selection.marked;
    std::vector<bool> wanted(picture.pixel_count());
    const TileRect& region = *selection.region;
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x) wanted[picture.pixel(x, y)] = true;
    return wanted;
}

/// One line per pixel and band; what is not defined, was not measured, or has no sample yet, is left empty. The last
/// column says how S2, S3 and the angles are labeled.
Result<Done> write_pixels(const StokesImage& picture, const std::vector<bool>& wanted, const Polarimeter& polarimeter,
                          const Convention& convention, const fs::path& path, ExportProgress& progress) {
    POL_TRY(auto file, OutputFile::create(path));
    const bool is_spectrum = !wavelengths_of(picture.bands).empty();
    std::string text =
        fmt::format("x,y,{},S0,S1,S2,S3,dop,azimuth_deg,ellipticity_angle_deg,residual,tail,samples,convention\n",
                    is_spectrum ? "wavelength_nm" : "band");
    const ShownPicture shown(picture, polarimeter, convention);
    const std::string labels = convention.stokes_text();
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t pixel = picture.pixel(x, y);
            if (!wanted.empty() && !wanted[pixel]) continue;
            const bool is_traced = picture.samples.empty() || picture.samples[pixel] > 0;
            for (std::size_t w = 0; w < picture.bands.size(); ++w) {
                const Stokes<double> s = shown.stokes(w, pixel);
                const StokesComponents known = shown.known(w);
                const bool is_full = known == StokesComponents::all();
                const Measures<double> m = measure(s, noise_threshold(1000.0));
                const auto number = [&](bool defined, double value) {
                    return is_traced && defined ? fmt::to_string(value) : std::string();
                };
                fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{},\"{}\"\n",
                               picture.left + x, picture.top + y,
                               is_spectrum ? fmt::to_string(*picture.bands[w].wavelength_nm) : picture.bands[w].name,
                               number(known.has(0), s.s0), number(known.has(1), s.s1), number(known.has(2), s.s2),
                               number(known.has(3), s.s3), number(m.has_light && is_full, m.dop),
                               number(m.has_azimuth && known.has(StokesComponents::linear()), degrees(m.azimuth)),
                               number(m.has_polarization && is_full, degrees(m.ellipticity_angle)),
                               is_traced ? picture.plane_value(picture.residual, w, pixel) : 1.0,
                               is_traced ? picture.plane_value(picture.tail, w, pixel) : 0.0,
                               picture.samples.empty() ? "" : fmt::to_string(picture.samples[pixel]), labels);
            }
        }
        file->write(text.data(), text.size());
        text.clear();
        progress = static_cast<double>(y + 1) / picture.height;
    }
    return file->commit();
}

}  // namespace

fs::path free_export_path(const Session& session, const std::string& stem, const std::string& ending) {
    std::error_code ignored;
    const fs::path folder = fs::is_directory("out", ignored) ? fs::path("out") : fs::path();
    for (int number = 1;; ++number) {
        const fs::path path = folder / (number == 1 ? stem + ending : fmt::format("{}-{}{}", stem, number, ending));
        if (!fs::exists(path, ignored) && !session.exports().will_write(path)) return path;
    }
}

void export_snapshot(Session& session) {
    const Document* document = session.current();
    if (document == nullptr) return;
    session.catch_up();
    const fs::path path = free_export_path(session, stem_of(*document), ".exr");
    std::optional<Scene> scene;
    if (document->has_scene()) scene = document->scene();
    session.start_export("EXR snapshot", path,
                         [lent = document->lend_picture(), scene = std::move(scene), name = document->name(),
                          path](ExportProgress& progress) mutable -> Result<Done> {
                             StokesImage image = *lent;
                             lent.reset();
                             if (scene) {
                                 forget_preview(image);
                                 image.attributes.merge(picture_attributes(*scene, image.samples, name));
                             }
                             return write_exr(image, path, [&](double share) { progress = share; });
                         });
}

fs::path export_map(Session& session) {
    const Document* document = session.current();
    if (document == nullptr) return {};
    session.catch_up();
    const ViewSettings& view = session.view();
    const std::string quantity(info(view.quantity).name);
    const auto comparison = session.comparison();
    const fs::path path =
        free_export_path(session, stem_of(*document) + "-" + quantity + (comparison ? "-difference" : ""), ".png");
    MapOptions options = map_options(session);
    if (view.quantity != Quantity::color) {
        session.finish_shown_map();
        options.range = map_look(session).range;
    }
    std::optional<LentReference> reference;
    std::string caption = document->name();
    if (const double done = document->progress().done; done < 1.0)
        caption += fmt::format(" at {:.0f} % of its samples", std::floor(100.0 * done));
    if (comparison) {
        reference = LentReference{comparison->reference->lend_picture(), comparison->band};
        caption += " minus " + comparison->reference->name();
    }
    if (document->chosen_convention())
        caption += ", its numbers taken for " + document->picture().origin.convention.text();
    if (!session.polarimeter().empty()) caption += ", behind the polarimeter";
    session.start_export("PNG of the map", path,
                         [lent = document->lend_picture(), view, options, polarimeter = session.polarimeter(),
                          reference = std::move(reference), caption, path](ExportProgress& progress) {
                             return write_map(*lent, view, options, polarimeter, reference, caption, path, progress);
                         });
    std::error_code ignored;
    return fs::absolute(path, ignored);
}

void export_pixels(Session& session) {
    const Document* document = session.current();
    if (document == nullptr) return;
    session.catch_up();
    const fs::path path = free_export_path(session, stem_of(*document), ".csv");
    session.start_export(
        "CSV of the pixels", path,
        [lent = document->lend_picture(), wanted = wanted_pixels(session.selection(), document->picture()),
         polarimeter = session.polarimeter(), convention = session.view().convention, path](ExportProgress& progress) {
            return write_pixels(*lent, wanted, polarimeter, convention, path, progress);
        });
}

void send_picture(Session& session, const LiveAddress& to) {
    const Document* document = session.current();
    if (document == nullptr) return;
    session.catch_up();
    // A viewer that does not read is given up.
    constexpr double most_s = 30.0;
    session.start_export(document->name() + " for a viewer", to.text(),
                         [lent = document->lend_picture(), name = document->name(), to](ExportProgress&) mutable {
                             const StokesImage image = *lent;
                             lent.reset();  // a render goes on in the window
                             return LiveSender(to, source_of(image, name)).finish(most_s);
                         });
}

void export_window(Session& session) {
    const Document* document = session.current();
    const std::string stem = document != nullptr ? stem_of(*document) : "polariscope";
    session.want_window_picture(free_export_path(session, stem + "-window", ".png"));
}

void write_window(Session& session, RgbPicture picture) {
    const fs::path path = session.wanted_window_picture();
    session.want_window_picture({});
    session.start_export("PNG of the window", path, [picture = std::move(picture), path](ExportProgress& /*progress*/) {
        return write_png(picture, path);
    });
}

}  // namespace pol
