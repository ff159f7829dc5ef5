// SPDX-License-Identifier: Apache-2.0
// Closing a document and ending the program lose edits that no file has: the user is asked first, and these are the
// answers.
#pragma once

#include "viewer/session/session.h"

namespace pol {

/// Closes the current document, or ends the program; if edits would be lost, asks instead (WindowState::question).
void close_or_ask(Session& session);
void end_or_ask(Session& session);

/// Whether what is asked about is this document.
bool would_be_lost(const Session& session, const Document& document);

// Answers. Without a question they do nothing
// --------------------------------------------------------------------------

/// Saves what would be lost, then closes or ends. If something cannot be saved, the log says why and the question
/// stays; if that needs an answer first (Question::rewrite), it is the one that is asked.
void save_and_go_on(Session& session);
void go_on_without_saving(Session& session);
void stay(Session& session);

/// To Question::rewrite: the old file is kept as NAME.bak.
void write_anew(Session& session);

}  // namespace pol
