// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "viewer/session/session.h"
#include "viewer/session/wishes.h"

namespace pol {

/// Keys and mouse at a glance, made from commands(), while WindowState::help_visible.
void draw_help_overlay(const Session& session, Wishes& wishes);

}  // namespace pol
