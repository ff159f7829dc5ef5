// SPDX-License-Identifier: Apache-2.0
// One lambda per alternative of a variant, visited in full.
#pragma once

namespace pol {

template <class... Lambdas>
struct Overloaded : Lambdas... {
    using Lambdas::operator()...;
};
template <class... Lambdas>
Overloaded(Lambdas...) -> Overloaded<Lambdas...>;

}  // namespace pol
