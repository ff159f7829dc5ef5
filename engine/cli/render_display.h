// SPDX-License-Identifier: Apache-2.0
// A render shown while it is made in a viewer that runs: tev, or a window that listens.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/result.h"
#include "io/live/live_sender.h"
#include "plan/plan.h"
#include "render/renderer.h"

namespace pol {

/// Sends the tiles of a renderer while they change. A display that is not there, or goes, disturbs no render.
class RenderDisplay {
public:
    /// `address` as read_live_address takes it; `name` is what the viewer calls the picture. Error (kind usage): it is
    /// no address. The renderer must outlive the display.
    static Result<std::unique_ptr<RenderDisplay>> open(const std::string& address, const std::string& name,
                                                       const Plan& plan, const Renderer& renderer);

    /// The render has ended: waits some seconds until the last tiles are sent. Says on stderr if they are not.
    void finish();

private:
    RenderDisplay(const LiveAddress& address, LiveSource source)
        : where_(address.text()), sender_(address, std::move(source)) {}

    std::string where_;
    LiveSender sender_;
};

}  // namespace pol
