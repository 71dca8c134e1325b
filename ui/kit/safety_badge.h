// Safety conditions as texts, and as a small badge: a shape, a colour and words.
#pragma once

#include <optional>
#include <vector>

#include <QDateTime>
#include <QString>

#include "map/safety.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"

class QPainter;

namespace mapwright::ui {

/// What is known, and whether it is still live.
struct SafetyState {
  std::vector<map::SafetyCondition> conditions;  // the gravest first
  std::optional<QDateTime> as_of;                // disconnected since then
  bool operator==(const SafetyState&) const = default;
};

struct SafetyText {
  Mark mark = Mark::None;  // None: nothing to say
  bool greyed = false;     // no longer live
  QString badge;           // "Emergency stop +2"
  QString sentence;        // one line for the notice; empty if nothing is an error
  QString detail;          // one line each, for the tooltip
  bool operator==(const SafetyText&) const = default;
};

SafetyText safetyText(const SafetyState& state, const QDateTime& now);

/// "Emergency stop", "Error 6004".
QString safetyWord(const map::SafetyCondition& condition);
/// "Emergency stop pressed since 14:03:12", "Error 6004 since 14:03:12: Kernel temperature is high".
QString safetySentence(const map::SafetyCondition& condition, const QDateTime& now);

/// The preferred width of paintSafety(); 0 if there is nothing to say.
int safetyWidth(const SafetyText& text, const QFont& font);
/// Text that does not fit is elided; shape and colour always stay.
void paintSafety(QPainter* painter, const QRect& rect, const SafetyText& text, const UiColors& colors);

}  // namespace mapwright::ui
