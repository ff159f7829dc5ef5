// SPDX-License-Identifier: Apache-2.0
#include "viewer/app/app_probe.h"

#include <imgui.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

namespace pol {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

ordered_json as_json(const ViewRect& rect) {
    return {rect.origin.x, rect.origin.y, rect.size.x, rect.size.y};
}

}  // namespace

void AppProbe::begin() {
    if (!asked_) return;
    widgets_ = {{}, folder_ / "panels.txt"};
    ImGui::GetIO().UserData = &widgets_;
    std::error_code ignored;
    fs::remove(widgets_.text_log, ignored);
}

void AppProbe::end(const Session& session, const ViewRect& viewport, bool is_final) {
    if (!asked_) return;
    ImGui::GetIO().UserData = nullptr;
    if (!is_final) return;
    asked_ = false;
    ordered_json report;
    report["viewport"] = as_json(viewport);
    report["scale"] = session.transform().scale;
    report["offset"] = {session.transform().offset.x, session.transform().offset.y};
    report["map"] = std::string(info(session.view().quantity).name);
    if (session.selection().node) report["node"] = *session.selection().node;
    report["documents"] = session.documents().size();
    if (const Document* document = session.current()) {
        report["document"] = document->path().string();
        report["dirty"] = document->dirty();
        report["done"] = document->progress().done;
        report["samples"] = document->progress().statistics.samples;
    }
    for (const auto& [name, rect] : widgets_.rects) report["widgets"][name] = as_json(rect);
    report["frame_s"] = std::exchange(costs_s_, {});
    report["latency_s"] = std::exchange(latencies_s_, {});
    const fs::path unfinished = folder_ / "window.json.new";
    std::ofstream(unfinished) << report.dump(1);
    std::error_code ignored;
    fs::rename(unfinished, folder_ / "window.json", ignored);
}

void AppProbe::note_frame(double cost_s, double latency_s) {
    costs_s_.push_back(cost_s);
    if (latency_s > 0.0) latencies_s_.push_back(latency_s);
}

}  // namespace pol
