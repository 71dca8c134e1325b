// The languages: which there are, which one is spoken, and that pictures that are compared stay in English.
#include <QCoreApplication>
#include <QTest>

#include "fault/fault.h"
#include "sentences/fault_sentence.h"
#include "sentences/language.h"
#include "sentences/overlay_name.h"
#include "sentences/plural.h"
#include "sentences/state_words.h"
#include "test_program.h"

namespace test_language {

using namespace mapwright;

namespace {

const QString kChinese = QStringLiteral("zh_CN");

QString wall() { return sentences::nameOf(map::OverlayShape::Line, 2); }

class TestLanguage : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void cleanup() { sentences::speak(QStringLiteral("en")); }

  void languagesAreCalledByTheirCodes() {
    QCOMPARE(sentences::languages().front().code, QStringLiteral("en"));
    QCOMPARE(sentences::languageCalled(kChinese), kChinese);
    QCOMPARE(sentences::languageCalled(QStringLiteral("zh")), kChinese);
    QCOMPARE(sentences::languageCalled(QStringLiteral("system")), sentences::languageOfSystem());
    for (const char* none : {"", "zh_TW", "de", "Chinese"})
      QVERIFY(!sentences::languageCalled(QLatin1String(none)));
  }

  void englishIsSpokenUntilAnotherLanguageIsChosen() {
    QCOMPARE(sentences::spokenLanguage(), QStringLiteral("en"));
    QCOMPARE(wall(), QStringLiteral("Virtual wall"));
    sentences::speak(kChinese);
    QCOMPARE(wall(), QStringLiteral("虚拟墙"));
    sentences::speak(QStringLiteral("en"));
    QCOMPARE(wall(), QStringLiteral("Virtual wall"));
  }

  void numbersHaveOneFormInChinese() {
    sentences::speak(kChinese);
    const auto submaps = [](qint64 n) {
      return sentences::counted(
          QCoreApplication::translate("window", "%1 submaps", nullptr, sentences::formOf(n)), n);
    };
    QCOMPARE(submaps(1).remove(QLatin1Char('1')), submaps(2).remove(QLatin1Char('2')));
    QVERIFY(submaps(12'480).contains(QStringLiteral("12,480")));
  }

  void picturesThatAreComparedAreInEnglish() {
    sentences::speak(kChinese);
    {
      const sentences::InEnglish labels;
      QCOMPARE(wall(), QStringLiteral("Virtual wall"));
    }
    QCOMPARE(wall(), QStringLiteral("虚拟墙"));
  }

  void whatWasSpokenIsKnownInEnglish() {
    QVERIFY(sentences::sourcesOf(wall()).isEmpty());
    sentences::speak(kChinese);
    QVERIFY(sentences::sourcesOf(wall()).contains(QStringLiteral("Virtual wall")));
    QVERIFY(sentences::sourcesOf(QStringLiteral("Virtual wall")).isEmpty());
  }

  void whatTheSystemSaysIsTranslatedAsWell() {
    const Fault kept(fault::said("Permission denied")), robots(fault::said("Door is stuck"));
    QCOMPARE(sentences::sentenceOf(kept), QStringLiteral("Permission denied."));
    sentences::speak(kChinese);
    QCOMPARE(sentences::sentenceOf(kept), QStringLiteral("权限不足。"));
    QCOMPARE(sentences::sentenceOf(robots), QStringLiteral("Door is stuck."));
  }

  void statesThatAreKnownAreTranslated() {
    QCOMPARE(sentences::stateWord("moving"), QStringLiteral("moving"));
    sentences::speak(kChinese);
    QCOMPARE(sentences::stateWord("moving"), QStringLiteral("移动中"));
    QCOMPARE(sentences::stateWord("dancing"), QStringLiteral("dancing"));
  }

  void whatQtSaysIsTranslatedAsWell() {
    sentences::speak(kChinese);
    QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("取消"));
    QCOMPARE(QCoreApplication::translate("QFileDialog", "File &name:"), QStringLiteral("文件名(&N)："));
  }
};

}  // namespace

}  // namespace test_language

MAPWRIGHT_TEST(test_language, TestLanguage, Core)
#include "test_language.moc"
