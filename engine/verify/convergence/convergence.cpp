// SPDX-License-Identifier: Apache-2.0
// Long because a sweep is one job: settings, reference, its check and all runs share what was measured so far.
#include "verify/convergence/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

#include "core/number_text.h"
#include "core/random.h"
#include "core/result.h"
#include "io/files/input_file.h"
#include "io/files/output_file.h"
#include "io/pictures/exr_file.h"
#include "io/scenes/scene_hash.h"
#include "plan/compile.h"
#include "polarization/coherence_matrix.h"
#include "render/renderer.h"
#include "scene/node_budget.h"
#include "verify/convergence/machine.h"
#include "verify/convergence/picture_parts.h"
#include "verify/invariants/invariants.h"

namespace pol::verify {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Shot {
    StokesImage image;
    RenderStatistics statistics{};
    std::string kernel;
    double trees = 1.0;  ///< per sample: wavelengths that share no tree have their own
    double compile_s = 0.0;
    double wall_s = 0.0;
    double cpu_s = 0.0;
};

class Sweep {
public:
    Sweep(const ConvergenceRequest& request, const ConvergenceWatch& watch)
        : request_(request), watch_(watch), hash_(scene_hash(request.scene)), cpu_(cpu_name()) {}

    Result<ConvergenceResult> run();

private:
    /// Empty when the user stops it; an error if the scene does not compile.
    Result<std::optional<Shot>> shoot(const RenderSettings& settings, const SpareParts& kept = {});
    Result<Done> find_reference();
    Result<Done> check_given_reference(const RenderSettings& deep);
    [[nodiscard]] RenderSettings deepest() const;
    Result<Done> read_stored_rows();
    Result<Done> take_over_rows();
    [[nodiscard]] Error not_ours(std::string what) const;
    Result<bool> measure_setting(const RunSetting& setting, std::uint64_t seed);
    [[nodiscard]] const RunRow* row_of(const RunSetting& setting, std::uint64_t seed) const;
    bool tell(const std::string& doing);
    [[nodiscard]] std::filesystem::path file(const char* name) const { return request_.folder / name; }
    Result<const StokesImage*> deeper_than(const RenderSettings& settings);
    void fill_errors(RunRow& row, const Shot& shot, const RenderSettings& settings, bool first_seed);

    const ConvergenceRequest& request_;
    const ConvergenceWatch& watch_;
    std::string hash_;
    std::string cpu_;
    std::vector<RunSetting> settings_;
    ConvergenceResult result_;
    std::vector<RunRow> stored_rows_;  ///< as the folder has them
    StokesImage reference_;
    bool stopped_ = false;
    std::map<int, StokesImage> deeper_;            ///< by samples per pixel
    std::map<std::string, StokesImage> previous_;  ///< picture of the seed before, by setting
    std::map<std::string, double> seconds_;        ///< what one measurement of a setting takes
    std::string doing_;
};

std::string key_of(const RunSetting& setting) {
    const RenderSettings& s = setting.settings;
    return setting.series + "|" + number_text(s.residual_in_force()) + "|" +
           (s.depth ? std::to_string(*s.depth) : "-") + "|" + std::to_string(s.node_budget.value()) + "|" +
           std::to_string(s.samples_per_pixel) + "|" + std::to_string(s.wavelengths_nm.size());
}

bool Sweep::tell(const std::string& doing) {
    doing_ = doing;
    ConvergenceProgress progress;
    progress.all = static_cast<int>(settings_.size()) * request_.seeds;
    progress.done = static_cast<int>(result_.rows.size());
    progress.doing = doing;
    // A setting that was not timed yet is taken to last as long as the mean of those that were.
    double known = 0.0;
    for (const auto& [key, seconds] : seconds_) known += seconds;
    if (!seconds_.empty()) {
        const double mean = known / static_cast<double>(seconds_.size());
        progress.seconds_left = 0.0;
        for (const RunSetting& setting : settings_) {
            const auto found = seconds_.find(key_of(setting));
            for (int seed = 0; seed < request_.seeds; ++seed)
                if (row_of(setting, static_cast<std::uint64_t>(seed)) == nullptr)
                    progress.seconds_left += found != seconds_.end() ? found->second : mean;
        }
    }
    if (!watch_(progress)) stopped_ = true;
    return !stopped_;
}

const RunRow* Sweep::row_of(const RunSetting& setting, std::uint64_t seed) const {
    const auto found = std::find_if(result_.rows.begin(), result_.rows.end(), [&](const RunRow& row) {
        const RenderSettings& s = setting.settings;
        const bool same_depth = s.depth ? row.depth_limit == *s.depth : std::isnan(row.depth_limit);
        return row.series == setting.series && row.residual_target == s.residual_in_force() && same_depth &&
               row.node_budget == s.node_budget.value() && row.samples_per_pixel == s.samples_per_pixel &&
               row.wavelengths == static_cast<double>(s.wavelengths_nm.size()) && row.seed == static_cast<double>(seed);
    });
    return found == result_.rows.end() ? nullptr : &*found;
}

Result<std::optional<Shot>> Sweep::shoot(const RenderSettings& settings, const SpareParts& kept) {
    Scene scene = request_.scene;
    scene.render = settings;
    Shot shot;
    const auto compiling = Clock::now();
    POL_TRY(auto plan, compile(scene, kept));
    shot.compile_s = seconds_since(compiling);
    shot.trees = static_cast<double>(plan->groups.size());
    shot.kernel = plan->features.kernel;
    Renderer renderer(request_.threads);
    const auto start = Clock::now();
    const double cpu_start = cpu_seconds();
    renderer.start(std::move(plan));
    while (!renderer.wait_for(0.1)) {
        if (tell(doing_)) continue;
        renderer.cancel();
        renderer.wait();
        return std::optional<Shot>();
    }
    shot.wall_s = seconds_since(start);
    shot.cpu_s = cpu_seconds() - cpu_start;
    shot.image = renderer.snapshot();
    const RenderProgress progress = renderer.progress();
    if (progress.reason == StopReason::memory)
        return Error{ErrorKind::internal, "there is no memory for this picture", {}, {}, "choose a smaller --size"};
    shot.statistics = progress.statistics;
    return std::optional(std::move(shot));
}

/// A smaller residual, more branches and more samples than any run has.
RenderSettings Sweep::deepest() const {
    double smallest = 1.0;
    int most_samples = 1;
    int largest_budget = 1;
    for (const RunSetting& setting : settings_) {
        if (setting.settings.depth) continue;
        smallest = std::min(smallest, setting.settings.residual_in_force());
        most_samples = std::max(most_samples, setting.settings.samples_per_pixel);
        largest_budget = std::max(largest_budget, setting.settings.node_budget.value());
    }
    RenderSettings deep = request_.scene.render;
    const bool area = deep.mode == SampleMode::area;
    deep.depth.reset();
    deep.residual = 0.03 * smallest;
    // Tails are unbiased: over many samples they need no larger head.
    deep.node_budget = area ? largest_budget : 8 * std::min(largest_budget, 1 << 27);
    deep.samples_per_pixel = area ? std::min(4 * most_samples, 1 << 24) : 1;
    deep.seed = 0x5eed0001ULL;
    return deep;
}

/// Root mean square of the standard errors that a picture comes with, in the unit of fro_c; 0: it has none.
double admitted_sampling(const StokesImage& image) {
    double sum = 0.0;
    for (const Stokes<double>& error : image.sampling_error)
        if (std::isfinite(error.s0)) sum += frobenius_square(error);
    return sum > 0.0 ? std::sqrt(sum / static_cast<double>(image.stokes.size())) / matrix_rms(image) : 0.0;
}

/// Of a foreign picture nothing is known but what it says itself, and that it must not contradict ours.
Result<Done> Sweep::check_given_reference(const RenderSettings& deep) {
    POL_TRY(auto read, read_exr(*request_.reference));
    reference_ = std::move(read);
    const auto refuse = [this](std::string what, const char* hint) {
        return Error{ErrorKind::usage, std::move(what), {request_.reference->string(), 0, 0}, "--reference", hint};
    };
    const RenderSettings& s = request_.scene.render;
    // Files name wavelengths to 1e-6 nm.
    const auto same_nm = [](double a, double b) { return std::abs(a - b) < 1e-5; };
    const std::vector<double> there = wavelengths_of(reference_.bands);
    if (reference_.width != s.width || reference_.height != s.height ||
        !std::equal(s.wavelengths_nm.begin(), s.wavelengths_nm.end(), there.begin(), there.end(), same_nm))
        return refuse("the reference has another size or other wavelengths than the runs",
                      "give --size and --wavelengths of the reference");
    for (const Band& band : reference_.bands)
        if (band.known != StokesComponents::all())
            return refuse(fmt::format("the reference does not have all Stokes components at {}", band.label()),
                          "give a picture with S0 to S3");
    if (reference_.left != 0 || reference_.top != 0)
        return refuse(fmt::format("the reference is a part of a picture, from its pixel {},{} on", reference_.left,
                                  reference_.top),
                      "give a whole picture");
    std::uint64_t content = 0;
    for (const Stokes<double>& light : reference_.stokes)
        for (const double value : {light.s0, light.s1, light.s2, light.s3}) {
            if (!std::isfinite(value))
                return refuse("a number of the reference is not finite", "polariscope check names it");
            content = mix_bits(content ^ std::bit_cast<std::uint64_t>(value));
        }
    // A file of the same name may hold another picture tomorrow: runs against that are not to be mixed with these.
    result_.reference_id = fmt::format("{} ({:016x})", request_.reference->filename().string(), content);

    doing_ = "our own picture, to check the reference";
    POL_TRY(const auto shot, shoot(deep));
    if (!shot) return Done{};
    const StokesImage& own = shot->image;
    // A number and the bounds beside it are each rounded once.
    const double rounding = 2.0 * reference_.stored.rounding();
    const double admitted = rounding + relative_bound(reference_, reference_) + admitted_sampling(reference_);
    ReferenceCheck check;
    check.difference = error_metrics(own, reference_).fro_c.whole;
    StokesImage untraced = own;
    const bool area = deep.mode == SampleMode::area;
    if (area) untraced.tail.clear();  // unbiased: its scatter is in the sampling error
    // The estimate of our own sampling error has few degrees of freedom where few pixels make most of it.
    constexpr double certain = 4.0;
    const double allowed_by_ours = relative_bound(untraced, reference_) + certain * admitted_sampling(own);
    check.allowed = allowed_by_ours + admitted;
    if (!area) check.covered = bound_coverage(own, reference_, rounding).covered;
    result_.reference_check = check;
    result_.reference_error = std::max(admitted, check.difference - allowed_by_ours);
    return Done{};
}

/// Our own: the deepest picture, by Embree instead of half-spaces where the scene allows it; twice, with seeds that no
/// run has, so that their difference tells the reference's own error.
Result<Done> Sweep::find_reference() {
    RenderSettings deep = deepest();
    if (request_.reference) return check_given_reference(deep);
    const bool area = deep.mode == SampleMode::area;
    Scene probe = request_.scene;
    const bool embree = static_cast<bool>(compile(probe, {.meshes = true}));
    result_.reference_id = std::string("own: residual ") + number_text(deep.residual_in_force()) + ", " +
                           std::to_string(deep.node_budget.value()) + " branches, 2 x " +
                           std::to_string(deep.samples_per_pixel) +
                           (area ? " samples" : " sample at the pixel centre") +
                           (embree ? ", solids met by Embree" : ", solids met as half-spaces");

    const auto stored = file("reference.exr");
    if (std::filesystem::exists(stored)) {
        auto read = read_exr(stored);
        if (read && read.value().attributes["scene_hash"] == hash_ &&
            read.value().attributes["settings"] == result_.reference_id) {
            reference_ = std::move(read).value();
            result_.reference_error = std::strtod(reference_.attributes["reference_error"].c_str(), nullptr);
            return Done{};
        }
    }
    std::vector<StokesImage> halves;
    for (const std::uint64_t seed : {0x5eed0001ULL, 0x5eed0002ULL}) {
        deep.seed = seed;
        doing_ = "reference " + std::to_string(halves.size() + 1) + " of 2";
        POL_TRY(auto shot, shoot(deep, {.meshes = embree}));
        if (!shot) return Done{};
        halves.push_back(std::move(shot->image));
    }
    reference_ = mean_of(halves[0], halves[1]);
    // The mean of two is off by half their difference; what neither traced comes on top, and the file's rounding.
    result_.reference_error = 0.5 * error_metrics(halves[0], halves[1]).fro_c.whole + 6e-8;
    StokesImage missing = reference_;
    missing.tail.clear();  // unbiased: its scatter is in the difference
    result_.reference_error += relative_bound(missing, reference_);
    reference_.attributes["scene_hash"] = hash_;
    reference_.attributes["settings"] = result_.reference_id;
    reference_.attributes["reference_error"] = number_text(result_.reference_error);
    return write_exr(reference_, stored);
}

/// Before anything is written: a folder of another scene is left as it is.
Result<Done> Sweep::read_stored_rows() {
    const auto path = file("runs.csv");
    if (!std::filesystem::exists(path)) return Done{};
    constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 28U;
    POL_TRY(auto text, read_input_file(path, most_bytes));
    POL_TRY(auto rows, parse_run_table(text, path.string()));
    stored_rows_ = std::move(rows);
    for (const RunRow& row : stored_rows_) {
        if (!is_comparable_hash(row.scene_hash))
            return not_ours(
                "the folder holds runs of another version of this program, which told scenes apart otherwise");
        if (row.scene_hash != hash_) return not_ours("the folder holds runs of another scene");
    }
    return Done{};
}

Result<Done> Sweep::take_over_rows() {
    for (RunRow& row : stored_rows_) {
        if (row.reference != result_.reference_id || row.threads != request_.threads)
            return not_ours("the folder holds runs with another reference or number of threads");
        result_.rows.push_back(std::move(row));
    }
    return Done{};
}

Error Sweep::not_ours(std::string what) const {
    return {ErrorKind::usage,
            std::move(what),
            {file("runs.csv").string(), 0, 0},
            "-o",
            "choose another folder, or remove this one"};
}

/// The same samples with a far smaller residual: what truncation alone does to a picture.
Result<const StokesImage*> Sweep::deeper_than(const RenderSettings& settings) {
    const auto found = deeper_.find(settings.samples_per_pixel);
    if (found != deeper_.end()) return &found->second;
    RenderSettings deep = settings;
    deep.depth.reset();
    deep.residual = 1e-6;
    deep.node_budget = 8 * node_budget_in_force(request_.scene);
    deep.wavelengths_nm = request_.scene.render.wavelengths_nm;
    POL_TRY(auto shot, shoot(deep));
    if (!shot) return static_cast<const StokesImage*>(nullptr);
    return &deeper_.emplace(settings.samples_per_pixel, std::move(shot->image)).first->second;
}

void Sweep::fill_errors(RunRow& row, const Shot& shot, const RenderSettings& settings, bool first_seed) {
    const StokesImage reference = at_wavelengths(reference_, settings.wavelengths_nm);
    const ErrorMetrics metrics = error_metrics(shot.image, reference);
    for (std::size_t i = 0; i < named_metrics.size(); ++i) row.errors[i] = metrics.*named_metrics[i].metric;
    row.nan_count = static_cast<double>(metrics.nan_count);
    row.energy_defect = shot.statistics.worst_energy_defect;
    row.failures = static_cast<double>(shot.statistics.failures);
    const LightDefects defects = light_defects(shot.image, tree_rounding(shot.statistics.most_nodes));
    row.psd_violations = static_cast<double>(defects.not_psd);
    row.s0_over_max = defects.s0_over_max;
    if (result_.rounding) {
        row.floating_point = result_.rounding->fro_c;
        row.topology_changes = static_cast<double>(result_.rounding->other_branches + result_.rounding->beyond_edge);
    }
    if (settings.wavelengths_nm.size() > 2)
        row.spectral = color_difference(every_second_wavelength(shot.image), shot.image);
    if (!first_seed || settings.samples_per_pixel > few_convergence_samples) return;
    const auto deep = deeper_than(settings);
    if (!deep || deep.value() == nullptr) return;
    const StokesImage truth = at_wavelengths(*deep.value(), settings.wavelengths_nm);
    row.truncation = error_metrics(shot.image, truth).fro_c.whole;
    const BoundCoverage coverage = bound_coverage(shot.image, truth, double_rounding);
    row.bound_fro = relative_bound(shot.image, truth);
    row.bound_mean = coverage.mean;
    row.bound_max = coverage.largest;
    row.bound_cover = coverage.covered;
    row.bound_ratio = coverage.ratio;
}

Result<bool> Sweep::measure_setting(const RunSetting& setting, std::uint64_t seed) {
    RenderSettings settings = setting.settings;
    settings.seed = seed;
    const auto begin = Clock::now();
    constexpr double enough_s = 1.0;
    constexpr double long_s = 2.0;
    RunRow row;
    row.timestamp = utc_now();
    row.host_load = load_average();
    Shot best;
    double spent = 0.0;
    int repeats = 0;
    while (repeats < request_.most_repeats && (repeats == 0 || (spent < enough_s && best.wall_s < long_s))) {
        POL_TRY(auto shot, shoot(settings));
        if (!shot) return false;
        spent += shot->wall_s;
        if (repeats == 0) best = std::move(*shot);
        best.wall_s = std::min(best.wall_s, shot->wall_s);
        best.cpu_s = std::min(best.cpu_s, shot->cpu_s);
        ++repeats;
    }
    row.series = setting.series;
    row.scene = request_.scene_name;
    row.scene_hash = hash_;
    row.mode = settings.mode == SampleMode::area ? "area" : "point";
    row.kernel = best.kernel;
    row.tool_version = request_.tool_version;
    row.cpu = cpu_;
    row.reference = result_.reference_id;
    row.reference_error = result_.reference_error;
    for (const double nm : settings.wavelengths_nm)
        row.wavelengths_nm += (row.wavelengths_nm.empty() ? "" : " ") + number_text(nm);
    row.cores = hardware_threads();
    row.threads = request_.threads;
    row.width = settings.width;
    row.height = settings.height;
    row.residual_target = settings.residual_in_force();
    if (settings.depth) row.depth_limit = *settings.depth;
    row.node_budget = settings.node_budget.value();
    row.samples_per_pixel = settings.samples_per_pixel;
    row.wavelengths = static_cast<double>(settings.wavelengths_nm.size());
    row.seed = static_cast<double>(seed);
    row.repeats = repeats;
    row.load_s = request_.load_s;
    row.compile_s = best.compile_s;
    row.render_wall_s = best.wall_s;
    row.render_cpu_s = best.cpu_s;
    row.rays = static_cast<double>(best.statistics.nodes);
    row.nodes_mean = row.rays / (best.trees * static_cast<double>(std::max<std::uint64_t>(1, best.statistics.samples)));
    row.nodes_max = best.statistics.most_nodes;
    fill_errors(row, best, settings, seed == 0);
    if (stopped_) return false;
    const auto before = previous_.find(key_of(setting));
    // The difference of two independent pictures has twice the variance of one; equal pictures are not independent.
    if (before != previous_.end() && before->second.stokes != best.image.stokes)
        row.sampling = error_metrics(best.image, before->second).fro_c.whole / std::sqrt(2.0);
    previous_[key_of(setting)] = std::move(best.image);
    result_.rows.push_back(std::move(row));
    seconds_[key_of(setting)] = seconds_since(begin);
    POL_TRY_DONE(write_file(file("runs.csv"), run_table_csv(result_.rows)));
    return true;
}

Result<ConvergenceResult> Sweep::run() {
    POL_TRY(auto plan, compile(request_.scene));
    settings_ = convergence_settings(request_.scene, plan->kernel().anisotropic);
    POL_TRY_DONE(read_stored_rows());
    POL_TRY_DONE(find_reference());
    if (stopped_) return std::move(result_);
    POL_TRY_DONE(take_over_rows());
    result_.rounding = rounding_error(*plan, [this](std::size_t) { return tell("rounding, in 128 bit"); });
    if (stopped_) return std::move(result_);
    result_.anytime = anytime_curve(plan, reference_, request_.threads,
                                    [this](std::size_t) { return tell("one render as it grows"); });
    if (stopped_) return std::move(result_);
    POL_TRY_DONE(write_file(file("anytime.csv"), anytime_csv(result_.anytime)));

    doing_ = "warm-up";
    POL_TRY_DONE(shoot(settings_.front().settings));
    for (int seed = 0; seed < request_.seeds && !stopped_; ++seed) {
        for (std::size_t i = 0; i < settings_.size() && !stopped_; ++i) {
            const RunSetting& setting = settings_[seed % 2 == 0 ? i : settings_.size() - 1 - i];
            if (row_of(setting, static_cast<std::uint64_t>(seed)) != nullptr) continue;
            if (!tell(setting.series + ", seed " + std::to_string(seed + 1) + " of " + std::to_string(request_.seeds)))
                break;
            POL_TRY_DONE(measure_setting(setting, static_cast<std::uint64_t>(seed)));
        }
    }
    result_.complete = !stopped_;
    return std::move(result_);
}

}  // namespace

Result<ConvergenceResult> converge(const ConvergenceRequest& request, const ConvergenceWatch& watch) {
    return Sweep(request, watch).run();
}

}  // namespace pol::verify
