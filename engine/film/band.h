// SPDX-License-Identifier: Apache-2.0
// What one plane set of a picture is of, and which of its Stokes components were measured.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polarization/mueller.h"

namespace pol {

/// A set of Stokes components.
class StokesComponents {
public:
    constexpr StokesComponents() = default;
    static constexpr StokesComponents all() { return StokesComponents(0b1111U); }
    /// What a photograph measures.
    static constexpr StokesComponents s0() { return StokesComponents(0b0001U); }
    /// What linear polarizers measure: S0, S1 and S2.
    static constexpr StokesComponents linear() { return StokesComponents(0b0111U); }

    /// `component` from 0 to 3.
    [[nodiscard]] constexpr bool has(unsigned component) const { return (bits_ >> component & 1U) != 0; }
    [[nodiscard]] constexpr bool has(StokesComponents others) const { return (bits_ & others.bits_) == others.bits_; }
    [[nodiscard]] constexpr StokesComponents with(unsigned component) const {
        return StokesComponents(bits_ | 1U << component);
    }
    [[nodiscard]] constexpr StokesComponents without(unsigned component) const {
        return StokesComponents(bits_ & ~(1U << component));
    }
    /// Bit i is component i.
    [[nodiscard]] constexpr unsigned bits() const { return bits_; }
    friend constexpr StokesComponents operator&(StokesComponents a, StokesComponents b) {
        return StokesComponents(a.bits_ & b.bits_);
    }
    friend constexpr bool operator==(StokesComponents, StokesComponents) = default;

private:
    explicit constexpr StokesComponents(unsigned bits) : bits_(bits) {}
    unsigned bits_ = 0;
};

/// Those that are known behind an optical element: component i of M s is if no unknown one has a part in it, that is if
/// |M_ij| is at most rounding (1e-12) of the largest |M| for every unknown j.
StokesComponents known_behind(const MuellerMatrix<double>& element, StokesComponents known);

/// The vector with 0 for what is not in `known`.
Stokes<double> only(StokesComponents known, const Stokes<double>& s);

/// A wavelength, or a name where there is none: a wavelength is never invented for "R" or "mono".
struct Band {
    std::optional<double> wavelength_nm;
    std::string name;  ///< "R", "G", "B", "mono", "Y", any text; empty if there is a wavelength
    /// Components that the numbers of this band have; the others are 0 in memory and mean nothing.
    StokesComponents known = StokesComponents::all();

    /// "580 nm" (shortest text), or the name.
    [[nodiscard]] std::string label() const;
    friend bool operator==(const Band&, const Band&) = default;
};

/// Bands at these wavelengths, all components known.
std::vector<Band> bands_at(const std::vector<double>& wavelengths_nm);
/// A band without a wavelength.
Band named_band(std::string_view name, StokesComponents known = StokesComponents::all());

/// The band of `bands` that is `wanted`: of the same wavelength to 1e-6 nm (files keep them as decimal texts), or
/// without one and of the same name.
std::optional<std::size_t> matching_band(const std::vector<Band>& bands, const Band& wanted);

/// The wavelengths if every band has one, else empty.
std::vector<double> wavelengths_of(const std::vector<Band>& bands);

/// Places of the bands named R, G and B, in this order; empty unless all three are there, each once.
std::optional<std::array<std::size_t, 3>> rgb_bands(const std::vector<Band>& bands);

}  // namespace pol
