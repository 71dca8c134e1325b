#include "sentences/state_words.h"

#include <QCoreApplication>

#include "words/qt_plain.h"

namespace mapwright::sentences {
namespace {

class StateText {
  Q_DECLARE_TR_FUNCTIONS(State)
};

}  // namespace

QString qualityWord(int quality) {
  switch (quality) {
    case 0:
      return StateText::tr("unknown");
    case 1:
      return StateText::tr("lost");
    case 3:
      return StateText::tr("poor");
    case 8:
      return StateText::tr("good");
    case 10:
      return StateText::tr("excellent");
    default:
      return StateText::tr("quality %1").arg(quality);
  }
}

QString plannerWord(const std::string& move_state) {
  if (move_state.empty()) return StateText::tr("its state is not told");
  if (move_state == "none" || move_state == "idle") return StateText::tr("idle");
  if (move_state == "moving") return StateText::tr("driving to its target");
  if (move_state == "succeeded") return StateText::tr("arrived");
  if (move_state == "failed") return StateText::tr("failed to get there");
  if (move_state == "cancelled") return StateText::tr("cancelled");
  return StateText::tr("\"%1\"").arg(words::plainName(move_state));
}

}  // namespace mapwright::sentences
