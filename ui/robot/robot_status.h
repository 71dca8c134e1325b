// The content of the Robot panel as plain values: sections of fields with words, marks and units.
#pragma once

#include <optional>
#include <vector>

#include <QDateTime>
#include <QString>

#include "map/live_state.h"
#include "ui/kit/status_text.h"

namespace mapwright::ui {

struct StatusField {
  QString name, value;  // untrusted plain text
  Mark mark = Mark::None;
  std::optional<double> bar;  // 0..1
  bool operator==(const StatusField&) const = default;
};

struct StatusSection {
  QString title;
  std::vector<StatusField> fields;  // never empty
  bool operator==(const StatusSection&) const = default;
};

struct AlertLine {
  Mark mark = Mark::Neutral;
  QString level, code, text, since;
  bool operator==(const AlertLine&) const = default;
};

/// What the robot has reported so far; unknown sections are left out.
std::vector<StatusSection> statusSections(const map::LiveState& live);
/// The same of a robot whose topics say no more about it: where it is and where it goes.
std::vector<StatusSection> topicSections(const map::LiveState& live);
/// Worst first, then oldest first.
std::vector<AlertLine> alertLines(const std::vector<map::Alert>& alerts, const QDateTime& now);

}  // namespace mapwright::ui
