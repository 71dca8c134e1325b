#include "sentences/plural.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include <QCoreApplication>
#include <QTranslator>

#include "words/figures.h"

namespace mapwright::sentences {
namespace {

struct Singular {
  const char* plural;
  const char* singular;
};

// tests/house compares it with the texts in the sources.
constexpr Singular kSingulars[] = {
    {"%1 alerts", "%1 alert"},
    {"%1 answers", "%1 answer"},
    {"%1 requests", "%1 request"},
    {"%1 cells", "%1 cell"},
    {"%1 changes", "%1 change"},
    {"%1 events", "%1 event"},
    {"%1 events copied", "%1 event copied"},
    {"%1 maps", "%1 map"},
    {"%1 messages", "%1 message"},
    {"%1 poses", "%1 pose"},
    {"%1 problems", "%1 problem"},
    {"%1 points", "%1 point"},
    {"%1 points are shown.", "%1 point is shown."},
    {"%1 points were received.", "%1 point was received."},
    {"clouds of %1 points", "a cloud of %1 point"},
    {"The robot has %1 projections.", "The robot has %1 projection."},
    {"The robot has answered, but %1 projections differ from what was sent. The table shows its answer.",
     "The robot has answered, but %1 projection differs from what was sent. The table shows its answer."},
    {"%1 points, evenly spread, are not shown, to save memory.", "%1 point is not shown, to save memory."},
    {"%1 more have invalid or absurdly large coordinates and were left out.",
     "%1 more has invalid or absurdly large coordinates and was left out."},
    {"%1 points that the robot announced did not arrive: its answer is cut off.",
     "%1 point that the robot announced did not arrive: its answer is cut off."},
    {"%1 points lie outside the requested region and were left out.",
     "%1 point lies outside the requested region and was left out."},
    {"%1 older clouds were discarded to save memory.", "%1 older cloud was discarded to save memory."},
    {"%1 more points have invalid or absurdly large coordinates and were left out.",
     "%1 more point has invalid or absurdly large coordinates and was left out."},
    {"%1 problems copied", "%1 problem copied"},
    {"%1 recordings", "%1 recording"},
    {"%1 slices", "%1 slice"},
    {"%1 specks", "%1 speck"},
    {"%1 submaps", "%1 submap"},
    {"%1 submaps are selected.", "%1 submap is selected."},
    {"%1 trajectories", "%1 trajectory"},
    {"%1 warnings", "%1 warning"},
    {"%1 waypoints", "%1 waypoint"},
    {"%1 waypoints are not sent: the robot does not allow duplicate names",
     "%1 waypoint is not sent: the robot does not allow duplicate names"},
    {"Waypoint types cannot be stored here: those of %1 waypoints are left out.",
     "Waypoint types cannot be stored here: that of %1 waypoint is left out."},
    {"Every waypoint needs a heading here: %1 waypoints without one get 0°.",
     "Every waypoint needs a heading here: %1 waypoint without one gets 0°."},
    {"Loading %1 submaps", "Loading %1 submap"},
    {"%1 older problems are no longer listed.", "%1 older problem is no longer listed."},
    {"%1 submaps could not be read back from the disk: parts of the picture are empty.",
     "%1 submap could not be read back from the disk: parts of the picture are empty."},
    {"%1 features that are not points were left out.", "%1 feature that is not a point was left out."},
    {"%1 rows without an id were left out.", "%1 row without an id was left out."},
    {"%1 points without a position were left out.", "%1 point without a position was left out."},
    {"%1 cells in its answers are outside the range of -1 to 100. Values above 100 are shown as 100, values "
     "below -1 as unknown.",
     "%1 cell in its answers is outside the range of -1 to 100. It is shown as 100 if it is above that, else "
     "as unknown."},
    {"%1 cells are outside the range of -1 to 100. They are shown as unknown.",
     "%1 cell is outside the range of -1 to 100. It is shown as unknown."},
    {"The robot accepted the picture, but shows %1 cells differently. Compare the two.",
     "The robot accepted the picture, but shows %1 cell differently. Compare the two."},
    {"%1 more points have pixel and metre coordinates that differ.",
     "%1 more point has pixel and metre coordinates that differ."},
    {"A message of %1 bytes is not a JSON object. It was left out.",
     "A message of %1 byte is not a JSON object. It was left out."},
    {"A binary message of %1 bytes is too short to be read. It was left out.",
     "A binary message of %1 byte is too short to be read. It was left out."},
    {"%1 bytes where %2 (or %3) were expected", "%1 byte where %2 (or %3) were expected"},
    {"Its header says %2 pixels, but %3 after %1 rows. The rest is shown as unknown.",
     "Its header says %2 pixels, but %3 after %1 row. The rest is shown as unknown."},
    {"Its header says %2 pixels, but %3 after %1 rows.", "Its header says %2 pixels, but %3 after %1 row."},
    {"%1 bytes of it cannot be read (from byte %2 on) and are skipped.",
     "%1 byte of it cannot be read (at byte %2) and is skipped."},
    {"%1 chunks of it cannot be unpacked (the first at byte %2) and are skipped.",
     "%1 chunk of it cannot be unpacked (at byte %2) and is skipped."},
    {"%1 chunks of it are corrupted (the first at byte %2) and are skipped.",
     "%1 chunk of it is corrupted (at byte %2) and is skipped."},
    {"%1 chunks of it would need too much memory (the first at byte %2) and are skipped.",
     "%1 chunk of it would need too much memory (at byte %2) and is skipped."},
    {"%1 chunks of it use an unknown compression: %3 (the first at byte %2). They are skipped.",
     "%1 chunk of it uses an unknown compression: %3 (at byte %2). It is skipped."},
    {"%1 chunks of it state a wrong time range (the first at byte %2).",
     "%1 chunk of it states a wrong time range (at byte %2)."},
    {"%1 message definitions in it are too large (the first at byte %2) and are skipped.",
     "%1 message definition in it is too large (at byte %2) and is skipped."},
    {"%1 message definitions in it cannot be read (the first at byte %2) and are skipped.",
     "%1 message definition in it cannot be read (at byte %2) and is skipped."},
    {"%1 messages belong to topics that it does not describe (the first at byte %2) and are skipped.",
     "%1 message belongs to a topic that it does not describe (at byte %2) and is skipped."},
    {"%1 topics are described twice and differently (the first at byte %2). The first description is used.",
     "%1 topic is described twice and differently (at byte %2). The first description is used."},
    {"The robot's answer (%1 bytes) is cut off or is not a submap.",
     "The robot's answer (%1 byte) is cut off or is not a submap."},
};

class EnglishPlurals : public QTranslator {
 public:
  using QTranslator::QTranslator;
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* text, const char*, int n) const override {
    return n == 1 ? singularOf(text) : QString();
  }
};

/// Asked last: translations that are installed later come before it.
void speakEnglish() { QCoreApplication::installTranslator(new EnglishPlurals(QCoreApplication::instance())); }
Q_COREAPP_STARTUP_FUNCTION(speakEnglish)

}  // namespace

QString counted(const QString& translated, qint64 count) {
  return translated.arg(QString::fromStdString(words::grouped(count)));
}

int formOf(qint64 count) { return int(std::min<qint64>(count, std::numeric_limits<int>::max())); }

QString singularOf(const char* plural) {
  for (const Singular& known : kSingulars) {
    if (std::strcmp(known.plural, plural) == 0) return QString::fromUtf8(known.singular);
  }
  return {};
}

}  // namespace mapwright::sentences
