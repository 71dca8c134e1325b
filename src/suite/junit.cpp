#include "suite/junit.h"

#include <QXmlStreamWriter>

#include "words/qt_plain.h"

namespace mapwright::suite {
namespace {

QString secondsText(double seconds) { return QString::number(seconds, 'f', 3); }

/// XML cannot hold control characters and what is no character.
QString inXml(const QString& text) {
  QString plain = words::plainLine(text);
  plain.replace(QChar(0xfffe), QChar(0xfffd)).replace(QChar(0xffff), QChar(0xfffd));
  return plain;
}

}  // namespace

bool writeJunit(const QString& suite, const std::vector<ViewOutcome>& outcomes, QIODevice& out) {
  const Tally tally = tallyOf(outcomes);
  double seconds = 0;
  for (const ViewOutcome& outcome : outcomes) seconds += outcome.seconds;
  QXmlStreamWriter xml(&out);
  xml.setAutoFormatting(true);
  xml.writeStartDocument();
  const auto count = [&] {
    xml.writeAttribute(QStringLiteral("tests"), QString::number(tally.all()));
    xml.writeAttribute(QStringLiteral("failures"),
                       QString::number(tally.differ + tally.over_limit + tally.not_expected_yet));
    xml.writeAttribute(QStringLiteral("errors"), QString::number(tally.failed));
    xml.writeAttribute(QStringLiteral("time"), secondsText(seconds));
  };
  xml.writeStartElement(QStringLiteral("testsuites"));
  count();
  xml.writeStartElement(QStringLiteral("testsuite"));
  xml.writeAttribute(QStringLiteral("name"), inXml(suite));
  count();
  for (const ViewOutcome& outcome : outcomes) {
    xml.writeStartElement(QStringLiteral("testcase"));
    xml.writeAttribute(QStringLiteral("name"), inXml(outcome.name));
    xml.writeAttribute(QStringLiteral("classname"), inXml(suite));
    xml.writeAttribute(QStringLiteral("time"), secondsText(outcome.seconds));
    if (outcome.verdict != Verdict::AsExpected) {
      xml.writeStartElement(outcome.verdict == Verdict::Failed ? QStringLiteral("error")
                                                               : QStringLiteral("failure"));
      xml.writeAttribute(QStringLiteral("type"), verdictText(outcome.verdict));
      const QStringList lines = outcome.sentence.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
      xml.writeAttribute(QStringLiteral("message"), inXml(lines.join(QLatin1Char(' '))));
      for (qsizetype i = 0; i < lines.size(); ++i)
        xml.writeCharacters((i > 0 ? QStringLiteral("\n") : QString()) + inXml(lines[i]));
      for (const QString& place : outcome.worst_closures + outcome.worst_squares)
        xml.writeCharacters(QLatin1Char('\n') + inXml(place));
      xml.writeEndElement();
    }
    if (!outcome.figures.empty()) {
      xml.writeStartElement(QStringLiteral("system-out"));
      for (const ViewOutcome::Figure& figure : outcome.figures)
        xml.writeCharacters(inXml(figure.words()) + QLatin1Char('\n'));
      xml.writeEndElement();
    }
    xml.writeEndElement();
  }
  xml.writeEndElement();
  xml.writeEndElement();
  xml.writeEndDocument();
  return !xml.hasError();
}

}  // namespace mapwright::suite
