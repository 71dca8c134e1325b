// What sources and documents refer to is there: every page that is named, and every heading of it; what the
// guides name of the code.
#include <algorithm>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

#include "test_program.h"

namespace test_documents {

namespace {

const QDir& repository() {
  static const QDir kRepository(QStringLiteral(MAPWRIGHT_SOURCES));
  return kRepository;
}

QString textOf(const QString& path) {
  QFile file(repository().filePath(path));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Paths from the repository's root.
QStringList filesNamed(const QStringList& patterns) {
  QStringList files;
  for (const char* top :
       {"app", "cmake", "docs", "packaging", "proto", "resources", "src", "tests", "ui", ".github"}) {
    QDirIterator it(repository().filePath(QLatin1String(top)), patterns, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext()) files << repository().relativeFilePath(it.next());
  }
  for (const QString& name : repository().entryList(patterns, QDir::Files)) files << name;
  return files;
}

QSet<QString> headingsOf(const QString& page) {
  static const QRegularExpression heading(QStringLiteral("^#+ (.+)$"), QRegularExpression::MultilineOption);
  QSet<QString> headings;
  for (auto it = heading.globalMatch(textOf(page)); it.hasNext();) {
    headings << it.next().captured(1).remove(QLatin1Char('`')).trimmed();
  }
  return headings;
}

/// As links name a heading: "mapwright-maps".
QString anchorOf(const QString& heading) {
  static const QRegularExpression odd(QStringLiteral("[^\\w -]"));
  return heading.toLower().remove(odd).replace(QLatin1Char(' '), QLatin1Char('-'));
}

/// What of a source's references leads nowhere: `docs/protocols/rosbridge.md, "Calls", "Topics"`, also over
/// the end of a line of a comment.
QStringList deadReferences(QString source) {
  static const QRegularExpression line_of_comment(QStringLiteral("\\n\\s*(//+|#) *"));
  source.replace(line_of_comment, QStringLiteral(" "));
  static const QRegularExpression reference(QStringLiteral("(\\w[\\w./-]*\\.md)\\b((?:, \"[^\"\\n]+\")*)"));
  static const QRegularExpression quoted(QStringLiteral("\"([^\"]+)\""));
  QStringList dead;
  for (auto it = reference.globalMatch(source); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    const QString page = match.captured(1);
    if (!QFile::exists(repository().filePath(page))) {
      dead << page;
      continue;
    }
    const QSet<QString> headings = headingsOf(page);
    for (auto named = quoted.globalMatch(match.captured(2)); named.hasNext();) {
      const QString heading = named.next().captured(1);
      if (!headings.contains(heading)) dead << page + QStringLiteral(", \"%1\"").arg(heading);
    }
  }
  return dead;
}

class TestDocuments : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void deadReferencesAreFound();
  void whatSourcesNameIsThere();
  void linksOfDocumentsLeadSomewhere();
  void guidesNameCodeThatIsThere();
};

void TestDocuments::deadReferencesAreFound() {
  const QString page = QStringLiteral("docs/protocols/rosbridge") + QStringLiteral(".md");
  QCOMPARE(deadReferences(QStringLiteral("// Source: %1, \"Calls\",\n// \"JSON\n// details\".").arg(page)),
           QStringList());
  QCOMPARE(deadReferences(QStringLiteral("// Source: %1, \"Call\".").arg(page)),
           QStringList{page + QStringLiteral(", \"Call\"")});
  const QString none = QStringLiteral("nowhere") + QStringLiteral(".md");
  QCOMPARE(deadReferences(QStringLiteral("/// As they say (%1).").arg(none)), QStringList{none});
}

void TestDocuments::whatSourcesNameIsThere() {
  const QStringList sources =
      filesNamed({QStringLiteral("*.h"), QStringLiteral("*.cpp"), QStringLiteral("*.proto"),
                  QStringLiteral("*.cmake"), QStringLiteral("CMakeLists.txt")});
  QVERIFY(sources.size() > 500);
  QStringList dead;
  for (const QString& path : sources) {
    for (const QString& reference : deadReferences(textOf(path)))
      dead << path + QLatin1String(": ") + reference;
  }
  QVERIFY2(dead.isEmpty(), qPrintable(QLatin1Char('\n') + dead.join(QLatin1Char('\n'))));
}

void TestDocuments::linksOfDocumentsLeadSomewhere() {
  static const QRegularExpression link(QStringLiteral("\\]\\(([^)#:]*)(#[^)]*)?\\)|`(docs/[\\w./-]+\\.md)`"));
  static const QRegularExpression code(QStringLiteral("^ {6,}.*$"), QRegularExpression::MultilineOption);
  QStringList dead;
  for (const QString& page : filesNamed({QStringLiteral("*.md")})) {
    const QString folder = QFileInfo(page).path();
    for (auto it = link.globalMatch(textOf(page).remove(code)); it.hasNext();) {
      const QRegularExpressionMatch match = it.next();
      const QString from_root = match.captured(3);
      const QString target = !from_root.isEmpty() ? from_root
                             : match.captured(1).isEmpty()
                                 ? page
                                 : QDir::cleanPath(folder + QLatin1Char('/') + match.captured(1));
      if (!QFileInfo::exists(repository().filePath(target))) dead << page + QLatin1String(": ") + target;
      const QString anchor = match.captured(2).mid(1);
      QStringList anchors;
      if (!anchor.isEmpty()) {
        for (const QString& heading : headingsOf(target)) anchors << anchorOf(heading);
      }
      if (!anchor.isEmpty() && !anchors.contains(anchor))
        dead << page + QLatin1String(": ") + target + QLatin1Char('#') + anchor;
    }
  }
  QVERIFY2(dead.isEmpty(), qPrintable(QLatin1Char('\n') + dead.join(QLatin1Char('\n'))));
}

/// Files and names of the code that the guides quote, such as `app/poses.cpp` or `wire::LinkRef`; what they
/// make up is listed here.
void TestDocuments::guidesNameCodeThatIsThere() {
  const QStringList made_up{QStringLiteral("app/state.cpp"),  QStringLiteral("addState"),
                            QStringLiteral("src/robot/NAME"), QStringLiteral("ui/NAME"),
                            QStringLiteral("your_layer"),     QStringLiteral("Yours"),
                            QStringLiteral("MyLink"),         QStringLiteral("NameController"),
                            QStringLiteral("NameDock"),       QStringLiteral("build/release/app/mapwright")};
  const QStringList files = filesNamed({QStringLiteral("*")});
  static const QRegularExpression source(QStringLiteral("\\.(h|cpp|cmake)$|CMakeLists\\.txt$"));
  static const QRegularExpression no_word(QStringLiteral("\\W+"));
  QSet<QString> words;
  for (const QString& path : files) {
    const QString text = source.match(path).hasMatch() ? path + QLatin1Char('\n') + textOf(path) : path;
    for (const QString& word : text.split(no_word)) words << word;
  }
  const auto isFile = [&](const QString& path) {
    return QFileInfo::exists(repository().filePath(path)) ||
           std::any_of(files.begin(), files.end(),
                       [&](const QString& file) { return file.endsWith(QLatin1Char('/') + path); });
  };
  static const QRegularExpression quoted(QStringLiteral("`([^`\n]+)`"));
  static const QRegularExpression path(QStringLiteral("^[\\w.-]+(/[\\w.-]+)+$"));
  static const QRegularExpression name(QStringLiteral("\\b[A-Za-z_]\\w{3,}\\b"));
  QStringList gone;
  int named = 0;
  for (const QString& guide : filesNamed({QStringLiteral("*.md")})) {
    if (!guide.startsWith(QLatin1String("docs/how-to/"))) continue;
    for (auto it = quoted.globalMatch(textOf(guide)); it.hasNext();) {
      const QString said = it.next().captured(1);
      ++named;
      if (path.match(said).hasMatch()) {
        if (!isFile(said) && !made_up.contains(said)) gone << guide + QLatin1String(": ") + said;
        continue;
      }
      for (auto one = name.globalMatch(said); one.hasNext();) {
        const QString word = one.next().captured();
        if (!words.contains(word) && !made_up.contains(word)) gone << guide + QLatin1String(": ") + word;
      }
    }
  }
  QVERIFY(named > 150);
  QVERIFY2(gone.isEmpty(), qPrintable(QLatin1Char('\n') + gone.join(QLatin1Char('\n'))));
}

}  // namespace

}  // namespace test_documents

MAPWRIGHT_TEST(test_documents, TestDocuments, Nothing)
#include "test_documents.moc"
