// SPDX-License-Identifier: Apache-2.0
// What the user wants, as the panels found it out while they drew a frame: they read the session, and whoever shows the
// frame changes it afterwards.
#pragma once

#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "viewer/session/session.h"

namespace pol {

/// Made anew for every frame.
class Wishes {
public:
    /// Something to do with the session. It has to make sense there whatever was wished before it in the same frame:
    /// the document may be another one.
    using Wish = std::function<void(Session&)>;

    void add(Wish wish) { wishes_.push_back(std::move(wish)); }

    /// One setting gets a value; the others stay as they are by then.
    template <class Value>
    void set(Value ViewSettings::*setting, std::type_identity_t<Value> value) {
        add([setting, value = std::move(value)](Session& session) { session.change_view().*setting = value; });
    }
    template <class Value>
    void set(Value WindowState::*setting, std::type_identity_t<Value> value) {
        add([setting, value = std::move(value)](Session& session) { session.change_window().*setting = value; });
    }

    [[nodiscard]] bool empty() const { return wishes_.empty(); }

    /// Does all of it, in the order in which it was wished, once.
    void fulfil(Session& session) {
        for (const Wish& wish : std::exchange(wishes_, {})) wish(session);
    }

private:
    std::vector<Wish> wishes_;
};

}  // namespace pol
