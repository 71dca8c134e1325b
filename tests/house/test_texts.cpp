// What people read can be translated: no sentence of the window and the command line stands outside of tr(),
// and what is counted has its singular.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>

#include "sentences/plural.h"
#include "test_program.h"

namespace test_texts {

using namespace mapwright;

namespace {

// Declared before the texts below, which moc does not read well.
class TestTexts : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void sentencesOutsideOfTrAreFound();
  void whatPeopleReadCanBeTranslated();
  void whatIsCountedHasItsSingular();
  void oneAndManyReadWell();
  void faultsNameTheirRoomAndEachArgumentOnce();
};

/// A text in the sources, its parts joined, with the code right before it.
struct Literal {
  QString text, before, after;
  int line = 0;
};

/// All but comments, raw texts (JSON, YAML, shaders) and single characters.
QList<Literal> literalsOf(const QString& source) {
  static const QRegularExpression token(
      QStringLiteral(
          "//[^\\n]*|/\\*.*?\\*/|"
          "R\"([^(]*)\\(.*?\\)\\1\"|'(?:\\\\[^']+|[^'\\\\\\n])'|\"((?:\\\\.|[^\"\\\\\\n])*)\"|\\w+|\\s+|."),
      QRegularExpression::DotMatchesEverythingOption);
  QList<Literal> literals;
  QString code;
  bool open = false;
  int line = 1;
  for (auto it = token.globalMatch(source); it.hasNext();) {
    const auto match = it.next();
    const QString word = match.captured(0);
    const bool blank = word.trimmed().isEmpty() || word.startsWith(QLatin1String("//")) ||
                       word.startsWith(QLatin1String("/*"));
    if (word.startsWith(QLatin1Char('"'))) {
      if (!open) literals.append({{}, code.right(120), {}, line});
      literals.last().text += match.captured(2);
      open = true;
    } else if (!blank) {
      if (open) literals.last().after = word;
      open = false;
    }
    code += blank ? QStringLiteral(" ") : word;
    line += int(word.count(QLatin1Char('\n')));
  }
  return literals;
}

/// Several words that begin large or end with a full stop, or three and more. Statements of SQL, markup and
/// code are none.
bool isSentence(const QString& text) {
  static const QRegularExpression words(QStringLiteral("[a-z]{2,},? [a-z]")),
      several(QStringLiteral("\\b[a-z]+,? [a-z]+,? [a-z]{2,}\\b")), any(QStringLiteral("\\b[A-Za-z]{2,}\\b")),
      code(QStringLiteral("[<>{};=]|://|yyyy|\\b(SELECT|FROM|WHERE|ROS)\\b|\\\\n")),
      begins(QStringLiteral("^[A-Z][a-z]")), ends(QStringLiteral("[a-z)]\\.$")),
      places(QStringLiteral("%[0-9n]"));
  QString plain = text;
  plain.replace(places, QStringLiteral("x"));
  plain = plain.trimmed();
  return plain.contains(several) ||
         (plain.contains(words) && (plain.contains(begins) || plain.contains(ends) ||
                                    (plain.count(any) > 2 && !plain.contains(code))));
}

/// Logs are read by who debugs, and searched for: they stay in English.
bool isLogged(const Literal& literal) {
  static const QRegularExpression call(QStringLiteral("\\bqC(Debug|Info)\\s*\\(\\s*\\w+,\\s*$"));
  return literal.before.contains(call);
}

bool isTranslated(const Literal& literal) {
  static const QRegularExpression call(
      QStringLiteral("(\\b(tr|QT_TR_NOOP)\\s*\\(|\\b(translate|faultText|QT_TRANSLATE_(N_)?NOOP)\\s*\\(\\s*"
                     "\"[^\"]*\"\\s*,)\\s*$"));
  return literal.before.contains(call);
}

template <typename See>
void eachLiteral(const QStringList& tops, See see) {
  const QDir sources(QStringLiteral(MAPWRIGHT_SOURCES));
  for (const QString& top : tops) {
    QDirIterator it(sources.filePath(top), {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext()) {
      const QString path = it.next();
      if (path.contains(QLatin1String("/app/bench/"))) continue;        // a program for those who build it
      if (path.endsWith(QLatin1String("/app/examples.cpp"))) continue;  // command lines
      QFile file(path);
      QVERIFY(file.open(QIODevice::ReadOnly));
      for (const Literal& literal : literalsOf(QString::fromUtf8(file.readAll())))
        see(QStringLiteral("%1:%2").arg(sources.relativeFilePath(path)).arg(literal.line), literal);
    }
  }
}

void TestTexts::sentencesOutsideOfTrAreFound() {
  const auto wrong = [](const char* code) {
    QStringList found;
    for (const Literal& literal : literalsOf(QString::fromUtf8(code))) {
      if (isSentence(literal.text) && !isTranslated(literal)) found << literal.text;
    }
    return found.join(QLatin1Char('|'));
  };
  QCOMPARE(wrong("fail(QStringLiteral(\"The map is \" /* of */ \"gone.\"), 10'000);"),
           QStringLiteral("The map is gone."));
  QCOMPARE(wrong("say(\"it is %1.\");"), QStringLiteral("it is %1."));
  QCOMPARE(wrong("why = \"its data is damaged\";"), QStringLiteral("its data is damaged"));
  QCOMPARE(wrong("lacks = \"map dispatcher (REP 130)\";"), QStringLiteral("map dispatcher (REP 130)"));
  QCOMPARE(wrong("say(tr(\"The map is gone.\"), Words::tr(\"It is \"\n"
                 "      \"back.\"), QCoreApplication::translate(\"window\", \"It is here.\"), '\"'); // "
                 "\"Not a text.\""),
           QString());
  QCOMPARE(wrong("setObjectName(\"compareBar\"); json[\"cell_area_m2\"]; option(\"--no-binary\");"),
           QString());
}

void TestTexts::whatPeopleReadCanBeTranslated() {
  const QSet<QString> allowed{
      QStringLiteral("Ground floor, east"),  // how wide a name may be
      // What the compiler says, and what Qt does.
      QStringLiteral("a row of blocks gives whole rows of a derived level"),
      QStringLiteral("pairs are read as bytes"),
      QStringLiteral("packed records are read as they lie in memory"),
      QStringLiteral("requests a version that we don't support"),
      QStringLiteral("processHandshake: Unknown error condition"),
      // What a server says, to be cut off.
      QStringLiteral("responded with an error: "),
      QStringLiteral("does not exist"),
      // What stands in a file for other programs.
      QStringLiteral("property float intensity\\n"),
      QStringLiteral("property uchar red\\nproperty uchar green\\nproperty uchar blue\\n"),
      QStringLiteral("SELECT id, name, type, serialization_format, "),
      // What numbers in a file are called there.
      QStringLiteral("x, y, z, yaw"),
      QStringLiteral("x, y, z, roll, pitch, yaw"),
      QStringLiteral("x, y, z, qx, qy, qz, qw"),
      QStringLiteral("qx, qy, qz, qw"),
  };
  int translated = 0;
  QStringList wrong;
  eachLiteral({QStringLiteral("ui"), QStringLiteral("app"), QStringLiteral("src")},
              [&](const QString& where, const Literal& literal) {
                // The robot that the program plays speaks for itself.
                const bool apart = where.startsWith(QLatin1String("src/simulator/")) ||
                                   // Definitions of messages, as ROS has them.
                                   where.startsWith(QLatin1String("src/recording/known_definitions.cpp"));
                const bool pattern = literal.text.startsWith(QLatin1Char('^'));
                // It says in comments for translators what it joins.
                const bool joins = where.startsWith(QLatin1String("src/words/"));
                if (apart || pattern || joins || isLogged(literal) || !isSentence(literal.text)) return;
                if (isTranslated(literal)) {
                  ++translated;
                } else if (!allowed.contains(literal.text)) {
                  wrong << where + QLatin1String(": ") + literal.text;
                }
              });
  QVERIFY(translated > 400);
  QVERIFY2(wrong.isEmpty(), qPrintable(QLatin1Char('\n') + wrong.join(QLatin1Char('\n'))));
}

void TestTexts::whatIsCountedHasItsSingular() {
  QSet<QString> counted;
  eachLiteral({QStringLiteral("ui"), QStringLiteral("app"), QStringLiteral("src")},
              [&](const QString& where, const Literal& literal) {
                const bool numerus = literal.after == QLatin1String(",") ||
                                     literal.before.contains(QLatin1String("QT_TRANSLATE_N_NOOP("));
                // What joins texts has a comment for translators there, and no number.
                const bool joins = where.startsWith(QLatin1String("src/words/"));
                if (isTranslated(literal) && numerus && !joins) counted << literal.text;
              });
  QVERIFY(counted.size() > 15);
  QFile file(QStringLiteral(MAPWRIGHT_SOURCES "/resources/mapwright_en.ts"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  QHash<QString, QString> singulars;
  QString source;
  for (QXmlStreamReader xml(&file); !xml.atEnd(); xml.readNext()) {
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() == QLatin1String("numerusform") && !singulars.contains(source))
      singulars.insert(source, xml.readElementText());
  }
  for (const QString& text : std::as_const(counted)) {
    const QString one = singulars.value(text);
    QVERIFY2(!one.isEmpty() && one != text, qPrintable(text));
    QVERIFY2(one.contains(QLatin1String("%1")), qPrintable(one));
  }
}

void TestTexts::oneAndManyReadWell() {
  const auto submaps = [](qint64 n) {
    return sentences::counted(
        QCoreApplication::translate("window", "%1 submaps", nullptr, sentences::formOf(n)), n);
  };
  QCOMPARE(submaps(0), QStringLiteral("0 submaps"));
  QCOMPARE(submaps(1), QStringLiteral("1 submap"));
  QCOMPARE(submaps(12'480), QStringLiteral("12,480 submaps"));
  QCOMPARE(submaps(5'000'000'000), QStringLiteral("5,000,000,000 submaps"));
}

void TestTexts::faultsNameTheirRoomAndEachArgumentOnce() {
  static const QRegularExpression declared(QStringLiteral(
      "(?:FaultCode \\w+\\{\\s*\"(\\w+)\",\\s*QT_TRANSLATE_(?:N_)?NOOP|faultText)\\(\\s*\"(\\w+)\",\\s*"
      "((?:\"(?:\\\\.|[^\"\\\\])*\"\\s*)+)")),
      place(QStringLiteral("%([1-9])")), between(QStringLiteral("\"\\s*\""));
  int seen = 0;
  QSet<QString> all;
  for (const char* const top : {"src", "ui", "app"}) {
    QDirIterator it(QStringLiteral(MAPWRIGHT_SOURCES "/%1").arg(QLatin1String(top)),
                    {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext()) {
      QFile file(it.next());
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QString room = QFileInfo(file.fileName()).dir().dirName();
      for (auto found = declared.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext(); ++seen) {
        const auto match = found.next();
        if (match.hasCaptured(1)) QCOMPARE(match.captured(1), room);
        QCOMPARE(match.captured(2), room);
        QString text = match.captured(3);
        text.remove(between);
        // A fault is known by its room and its words.
        QVERIFY2(!all.contains(room + text), qPrintable(text));
        all << room + text;
        QStringList places;
        for (auto one = place.globalMatch(text); one.hasNext();) places << one.next().captured(1);
        places.sort();
        for (qsizetype i = 0; i < places.size(); ++i)
          QVERIFY2(places[i].toInt() == int(i) + 1, qPrintable(text));
      }
    }
  }
  QVERIFY(seen > 300);
}

}  // namespace

}  // namespace test_texts

MAPWRIGHT_TEST(test_texts, TestTexts, Core)
#include "test_texts.moc"
