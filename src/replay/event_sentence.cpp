#include "replay/event_sentence.h"

#include <QCoreApplication>

#include "sentences/state_words.h"
#include "words/qt_plain.h"

namespace mapwright::replay {
namespace {

class TimelineEventsText {
  Q_DECLARE_TR_FUNCTIONS(TimelineEvents)
};

constexpr qsizetype kEventTextLength = 120;

}  // namespace

QString eventText(const Event& event) {
  const QString text = words::plainName(event.text).left(kEventTextLength);
  switch (event.kind) {
    case EventKind::AlertBegan:
      return text.isEmpty() ? TimelineEventsText::tr("Alert %1").arg(event.code)
                            : TimelineEventsText::tr("Alert %1: %2").arg(QString::number(event.code), text);
    case EventKind::AlertEnded:
      return text.isEmpty()
                 ? TimelineEventsText::tr("Alert %1 ended").arg(event.code)
                 : TimelineEventsText::tr("Alert %1 ended: %2").arg(QString::number(event.code), text);
    case EventKind::MoveState:
      return text.isEmpty()
                 ? TimelineEventsText::tr("Planner: idle")
                 : TimelineEventsText::tr("Planner: %1").arg(sentences::stateWord(text.toStdString()));
    case EventKind::PositionJump:
      return TimelineEventsText::tr("The position jumped by %1 m").arg(event.metres, 0, 'f', 1);
    case EventKind::MapChanged:
      return TimelineEventsText::tr("Map changed: %1").arg(text);
    case EventKind::SessionChanged:
      return TimelineEventsText::tr("New SLAM session");
    case EventKind::QualityLow:
      return TimelineEventsText::tr("Localization is poor or lost");
    case EventKind::QualityGood:
      return TimelineEventsText::tr("Localization is good again");
    case EventKind::EmergencyStopOn:
      return TimelineEventsText::tr("Emergency stop pressed");
    case EventKind::EmergencyStopOff:
      return TimelineEventsText::tr("Emergency stop released");
  }
  return {};
}

}  // namespace mapwright::replay
