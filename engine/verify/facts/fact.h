// SPDX-License-Identifier: Apache-2.0
// Facts of polarization optics with a closed form (PHYSICS.md 5), each with scenes in which the tracer must show it:
// `polariscope check facts` runs it and the window's "Facts" menu opens its scenes.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "tracer/explain.h"

namespace pol::verify {

/// Largest deviation of a measured number from the closed form that is not a fault, and why it is as large as that.
struct Tolerance {
    double value = 0.0;
    std::string from;
};

/// A scene in which a fact can be seen at one pixel.
struct FactView {
    std::string name;  ///< tells the views of one fact apart: "45 degrees"
    std::string yaml;  ///< whole scene of one wavelength; parse_scene with the shipped assets as its folder reads it
    int x = 0;         ///< the pixel; its ray is the one that the closed form is about
    int y = 0;
    double wavelength_nm = 580.0;
};

/// One number of a fact.
struct Reading {
    std::size_t view = 0;  ///< index into Fact::views
    std::string what;      ///< "reflectance of s"
    std::string unit;      ///< "deg"; empty: a pure number
    double expected = 0.0;
    Tolerance tolerance;
    /// The number as found in the explanation of the view's pixel. NaN if the tree has nothing like it.
    std::function<double(const Explanation&)> measure;
};

struct Fact {
    std::string id;        ///< "T1"
    std::string sentence;  ///< the physics in plain words
    std::string source;    ///< where the closed form stands
    std::vector<FactView> views{};
    std::vector<Reading> readings{};
    std::string not_modelled{};  ///< why the tracer cannot show it; empty: it can
};

/// "45 degrees: reflectance of s": what the reading is, in which view.
std::string label(const Fact& fact, const Reading& reading);

enum class Verdict {
    pass,
    fail,
    not_modelled,
};
/// "pass", "FAIL", "not modelled".
std::string_view verdict_text(Verdict verdict);

struct ReadingResult {
    double measured = 0.0;
    double deviation = 0.0;  ///< measured - expected, in tolerances; NaN if nothing was measured
    Verdict verdict = Verdict::fail;
};

struct FactResult {
    Verdict verdict = Verdict::fail;
    std::vector<ReadingResult> readings{};  ///< as Fact::readings; empty if there is an error
    /// A scene of the fact cannot be loaded, or the tree of its pixel is not what the picture is made of.
    std::optional<Error> error{};
};

/// T1, T2, ... in this order.
const std::vector<Fact>& facts();

/// The fact with that id, in any case ("t9"), or nullptr.
const Fact* find_fact(std::string_view id);

/// Compares one reading with the explanation of its view's pixel.
ReadingResult judge(const Reading& reading, const Explanation& explanation);

/// The tree of the view's pixel, through the same loader, compiler and kernel as a picture.
Result<Explanation> explain_view(const FactView& view);

/// Traces every view's pixel and judges every reading.
FactResult run_fact(const Fact& fact);

}  // namespace pol::verify
