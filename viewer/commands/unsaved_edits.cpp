// SPDX-License-Identifier: Apache-2.0
#include "viewer/commands/unsaved_edits.h"

#include "viewer/commands/command_actions.h"

namespace pol {

namespace {

/// False if that failed, or if it needs an answer first.
bool save_all(Session& session) {
    for (std::size_t i = 0; i < session.documents().size(); ++i) {
        if (session.current()->dirty() && !action::save_scene(session)) return false;
        session.step_document(1);
    }
    return true;
}

}  // namespace

void close_or_ask(Session& session) {
    if (session.current() == nullptr) return;
    if (session.current()->dirty())
        session.change_window().question = Question::unsaved_at_close;
    else
        session.close_document();
}

void end_or_ask(Session& session) {
    if (session.has_unsaved_edits())
        session.change_window().question = Question::unsaved_at_end;
    else
        session.change_window().ended = true;
}

bool would_be_lost(const Session& session, const Document& document) {
    return document.dirty() &&
           (session.window().question != Question::unsaved_at_close || &document == session.current());
}

void save_and_go_on(Session& session) {
    const Question question = session.window().question;
    const bool saved = question == Question::unsaved_at_close ? action::save_scene(session) : save_all(session);
    if (saved) go_on_without_saving(session);
}

void go_on_without_saving(Session& session) {
    WindowState& window = session.change_window();
    if (window.question == Question::unsaved_at_end) window.ended = true;
    if (window.question == Question::unsaved_at_close) session.close_document();
    window.question = Question::none;
}

void stay(Session& session) {
    session.change_window().question = Question::none;
}

void write_anew(Session& session) {
    if (session.window().question != Question::rewrite) return;
    stay(session);
    session.save(session.current()->path(), Document::Rewrite::keep_backup);
}

}  // namespace pol
