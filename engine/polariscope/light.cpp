// SPDX-License-Identifier: Apache-2.0
#include "polariscope/light.h"

#include "polarization/coherence_matrix.h"

namespace polariscope {

Coherence coherence(const Stokes& light) {
    const pol::CoherenceMatrix<double> j =
        pol::to_coherence(pol::Stokes<double>{light.s0, light.s1, light.s2, light.s3});
    return {j.xx, j.yy, {j.xy.re, j.xy.im}};
}

Stokes stokes(const Coherence& light) {
    const pol::Stokes<double> s =
        pol::to_stokes(pol::CoherenceMatrix<double>{light.xx, light.yy, {light.xy.real(), light.xy.imag()}});
    return {s.s0, s.s1, s.s2, s.s3};
}

}  // namespace polariscope
