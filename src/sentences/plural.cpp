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

// tests/house compares it with what is written in the sources.
constexpr Singular kSingulars[] = {
    {"%1 alerts", "%1 alert"},
    {"%1 answers", "%1 answer"},
    {"%1 calls", "%1 call"},
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
    {"%1 points have come.", "%1 point has come."},
    {"clouds of %1 points", "a cloud of %1 point"},
    {"The robot projects %1 maps.", "The robot projects %1 map."},
    {"The robot has answered, but %1 projections are not what it was sent. The table shows what it says.",
     "The robot has answered, but %1 projection is not what it was sent. The table shows what it says."},
    {"%1 points are left out evenly, to save memory.", "%1 point is left out, to save memory."},
    {"%1 more are no numbers, or absurdly far away. They are left out.",
     "%1 more is no number, or absurdly far away. It is left out."},
    {"%1 points that the robot says it sent have not come: its answer is cut off.",
     "%1 point that the robot says it sent has not come: its answer is cut off."},
    {"%1 points that came lie beyond the region that was asked for. They are left out.",
     "%1 point that came lies beyond the region that was asked for. It is left out."},
    {"%1 older clouds have been let go, to save memory.", "%1 older cloud has been let go, to save memory."},
    {"%1 more points are no numbers, or absurdly far away. They are left out.",
     "%1 more point is no number, or absurdly far away. It is left out."},
    {"%1 problems copied", "%1 problem copied"},
    {"%1 recordings", "%1 recording"},
    {"%1 slices", "%1 slice"},
    {"%1 specks", "%1 speck"},
    {"%1 submaps", "%1 submap"},
    {"%1 submaps are selected.", "%1 submap is selected."},
    {"%1 trajectories", "%1 trajectory"},
    {"%1 warnings", "%1 warning"},
    {"%1 waypoints", "%1 waypoint"},
    {"%1 waypoints are not sent: the robot refuses a name that another one has",
     "%1 waypoint is not sent: the robot refuses a name that another one has"},
    {"Types are not kept here: those of %1 waypoints are left out.",
     "Types are not kept here: that of %1 waypoint is left out."},
    {"Every waypoint has a heading here: %1 waypoints without one get 0°.",
     "Every waypoint has a heading here: %1 waypoint without one gets 0°."},
    {"Loading %1 submaps", "Loading %1 submap"},
    {"%1 older problems are not kept.", "%1 older problem is not kept."},
    {"%1 submaps could not be read back from the disk: parts of the picture are empty.",
     "%1 submap could not be read back from the disk: parts of the picture are empty."},
    {"%1 features that are no points were left out.", "%1 feature that is no point was left out."},
    {"%1 rows without an id were left out.", "%1 row without an id was left out."},
    {"%1 points without a place were left out.", "%1 point without a place was left out."},
    {"%1 cells of its answers are neither -1 nor 0 to 100. Those above 100 are shown as 100, those below -1 "
     "as unknown.",
     "%1 cell of its answers is neither -1 nor 0 to 100. It is shown as 100 if it is above that, else as "
     "unknown."},
    {"%1 cells are neither -1 nor 0 to 100. They are shown as unknown.",
     "%1 cell is neither -1 nor 0 to 100. It is shown as unknown."},
    {"The robot has taken the picture, but shows %1 cells otherwise than they were sent. Compare both.",
     "The robot has taken the picture, but shows %1 cell otherwise than it was sent. Compare both."},
    {"%1 points more disagree with their pixels.", "%1 point more disagrees with its pixels."},
    {"A message of %1 bytes is not a JSON object. It was left out.",
     "A message of %1 byte is not a JSON object. It was left out."},
    {"A binary message of %1 bytes is too short to be read. It was left out.",
     "A binary message of %1 byte is too short to be read. It was left out."},
    {"%1 bytes where %2 (or %3) were expected", "%1 byte where %2 (or %3) were expected"},
    {"It says that it is %2 pixels, but %3 after %1 rows. The rest is shown as unknown.",
     "It says that it is %2 pixels, but %3 after %1 row. The rest is shown as unknown."},
    {"It says that it is %2 pixels, but %3 after %1 rows.",
     "It says that it is %2 pixels, but %3 after %1 row."},
    {"%1 bytes of it are nothing that can be read (from byte %2 on). They are skipped.",
     "%1 byte of it is nothing that can be read (at byte %2). It is skipped."},
    {"%1 parts of it cannot be unpacked (the first at byte %2). They are skipped.",
     "%1 part of it cannot be unpacked (at byte %2). It is skipped."},
    {"%1 parts of it are not what was written (the first at byte %2). They are skipped.",
     "%1 part of it is not what was written (at byte %2). It is skipped."},
    {"%1 parts of it would take too much memory (the first at byte %2). They are skipped.",
     "%1 part of it would take too much memory (at byte %2). It is skipped."},
    {"%1 parts of it are compressed in a way that is not known here: %3 (the first at byte %2). They are "
     "skipped.",
     "%1 part of it is compressed in a way that is not known here: %3 (at byte %2). It is skipped."},
    {"%1 parts of it say wrong times of themselves (the first at byte %2).",
     "%1 part of it says wrong times of itself (at byte %2)."},
    {"Its index names %1 messages that are not there (the first at byte %2).",
     "Its index names %1 message that is not there (at byte %2)."},
    {"%1 descriptions in it are too large (the first at byte %2). They are skipped.",
     "%1 description in it is too large (at byte %2). It is skipped."},
    {"%1 descriptions in it cannot be read (the first at byte %2). They are skipped.",
     "%1 description in it cannot be read (at byte %2). It is skipped."},
    {"%1 messages are of topics that it does not describe (the first at byte %2). They are skipped.",
     "%1 message is of a topic that it does not describe (at byte %2). It is skipped."},
    {"%1 topics are described twice and differently (the first at byte %2). The first stands.",
     "%1 topic is described twice and differently (at byte %2). The first stands."},
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
