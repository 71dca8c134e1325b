#include "suite/suite_page.h"

#include <QCoreApplication>

#include "disk/read_file.h"
#include "page/page.h"
#include "sentences/plural.h"

namespace mapwright::suite {
namespace {

struct SuitePageText {
  Q_DECLARE_TR_FUNCTIONS(SuitePage)
};

constexpr std::size_t kMostPictureBytes = std::size_t(256) << 20;

page::Tone toneOf(Verdict verdict) {
  return verdict == Verdict::AsExpected       ? page::Tone::Good
         : verdict == Verdict::NotExpectedYet ? page::Tone::Warning
                                              : page::Tone::Bad;
}

QString anchorOf(std::size_t view) { return QStringLiteral("view%1").arg(view + 1); }

/// Empty: there is none, or it cannot be read any more.
QByteArray bytesOf(const QString& path) {
  if (path.isEmpty()) return {};
  const auto bytes = disk::readFile(path.toStdString(), kMostPictureBytes);
  return bytes ? QByteArray::fromStdString(*bytes) : QByteArray();
}

void putPictures(const ViewOutcome& outcome, page::Page& page) {
  const QByteArray expected = bytesOf(outcome.expected), actual = bytesOf(outcome.actual),
                   difference = bytesOf(outcome.difference);
  if (!expected.isEmpty() && !actual.isEmpty()) {
    page.beginColumns();
    page.swipe(expected, actual, SuitePageText::tr("Expected"), SuitePageText::tr("Actual"));
    page.nextColumn();
    if (!difference.isEmpty())
      page.picture(difference, {}, SuitePageText::tr("Difference"),
                   SuitePageText::tr("What differs, in a strong colour; clusters in boxes."));
    page.endColumns();
  } else if (!actual.isEmpty()) {
    page.picture(actual, {}, SuitePageText::tr("Actual"), SuitePageText::tr("Actual"));
  }
}

void putClusters(const ViewOutcome& outcome, page::Page& page) {
  if (!outcome.clusters.empty()) {
    page.beginTable({SuitePageText::tr("Box in pixels"), SuitePageText::tr("Pixels"),
                     SuitePageText::tr("At, in metres"), SuitePageText::tr("What changed there")});
    for (const ViewOutcome::ClusterRow& row : outcome.clusters)
      page.row({row.box, page::figure(row.size), row.place, row.near});
    page.endTable();
    if (const qint64 more = outcome.clusters_in_all - qint64(outcome.clusters.size()); more > 0)
      page.paragraph(
          sentences::counted(SuitePageText::tr("%1 more are not listed.", nullptr, sentences::formOf(more)),
                             more),
          page::Tone::Muted);
  }
  for (const auto& [title, changes] :
       {std::pair(SuitePageText::tr("Changed as well"), &outcome.everywhere),
        std::pair(SuitePageText::tr("Changed there or elsewhere"), &outcome.somewhere),
        std::pair(SuitePageText::tr("Changed elsewhere"), &outcome.elsewhere)}) {
    if (changes->isEmpty()) continue;
    page.title(title);
    page.list(*changes);
  }
}

void putQuality(const ViewOutcome& outcome, page::Page& page) {
  if (!outcome.figures.empty()) {
    page.beginTable({SuitePageText::tr("SLAM session"), SuitePageText::tr("Expected"),
                     SuitePageText::tr("Actual"), SuitePageText::tr("Limit")});
    for (const ViewOutcome::Figure& figure : outcome.figures)
      page.row(
          {figure.name, page::figure(figure.before), page::figure(figure.now), page::figure(figure.limit)});
    page.endTable();
  }
  for (const auto& [title, places] :
       {std::pair(SuitePageText::tr("Loop closures over the limit"), &outcome.worst_closures),
        std::pair(SuitePageText::tr("Where submaps contradict each other most"), &outcome.worst_squares)}) {
    if (places->isEmpty()) continue;
    page.title(title);
    page.list(*places);
  }
}

/// Has a section of its own.
bool isTold(const ViewOutcome& outcome) {
  return outcome.verdict != Verdict::AsExpected || !outcome.figures.empty();
}

}  // namespace

bool writePage(const QString& suite, const std::vector<ViewOutcome>& outcomes, QIODevice& out) {
  const Tally tally = tallyOf(outcomes);
  page::Page page(out, suite, page::Scripts::Swipe);
  page.paragraph(tallyText(tally), tally.good() ? page::Tone::Good : page::Tone::Bad);
  page.section(SuitePageText::tr("All views"));
  page.beginTable({SuitePageText::tr("View"), SuitePageText::tr("Result")});
  for (const bool good : {false, true}) {
    for (std::size_t view = 0; view < outcomes.size(); ++view) {
      const Verdict verdict = outcomes[view].verdict;
      if ((verdict == Verdict::AsExpected) != good) continue;
      page::Cell name(outcomes[view].name);
      if (isTold(outcomes[view])) name.link = anchorOf(view);
      page.row({name, page::Cell(verdictText(verdict), toneOf(verdict))});
    }
  }
  page.endTable();
  for (std::size_t view = 0; view < outcomes.size(); ++view) {
    const ViewOutcome& outcome = outcomes[view];
    if (!isTold(outcome)) continue;
    page.section(outcome.name, anchorOf(view));
    page.paragraph(verdictText(outcome.verdict), toneOf(outcome.verdict));
    for (const QString& line : outcome.sentence.split(QLatin1Char('\n'), Qt::SkipEmptyParts))
      page.paragraph(line);
    putPictures(outcome, page);
    putClusters(outcome, page);
    putQuality(outcome, page);
  }
  return page.end();
}

}  // namespace mapwright::suite
