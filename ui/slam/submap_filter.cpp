#include "ui/slam/submap_filter.h"

#include <algorithm>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "sentences/language.h"
#include "ui/kit/status_text.h"

namespace mapwright::ui {

namespace {

bool allDigits(QStringView text) {
  return !text.isEmpty() &&
         std::all_of(text.begin(), text.end(), [](QChar c) { return c >= u'0' && c <= u'9'; });
}

bool wordMatches(const QString& word, const SubmapFacts& facts) {
  const QString index = QString::number(facts.id.index);
  if (word.startsWith(QLatin1Char('#'))) return index.startsWith(QStringView(word).mid(1));
  if (allDigits(word)) return index.startsWith(word);
  if (word.startsWith(QLatin1Char('v')) && allDigits(QStringView(word).mid(1))) {
    return QString::number(facts.version) == QStringView(word).mid(1);
  }
  const auto dash = word.indexOf(QLatin1Char('-'));
  if (dash > 0 && allDigits(QStringView(word).left(dash))) {
    return QString::number(facts.id.trajectory) == QStringView(word).left(dash) &&
           index.startsWith(QStringView(word).mid(dash + 1));
  }
  QStringList says{facts.frozen ? QStringLiteral("frozen") : QStringLiteral("active"),
                   facts.visible ? QStringLiteral("visible") : QStringLiteral("hidden")};
  if (facts.incremental) says << QStringLiteral("incremental");
  if (facts.nearby) says << QStringLiteral("nearby");
  {
    const sentences::InEnglish as_documented;
    says << statusWord(facts.status);
  }
  says << statusWord(facts.status) << badges(facts);  // as they are shown
  return std::any_of(says.begin(), says.end(),
                     [&word](const QString& s) { return s.startsWith(word, Qt::CaseInsensitive); });
}

}  // namespace

QStringList badges(const SubmapFacts& facts) {
  QStringList names{facts.frozen ? QCoreApplication::translate("window", "FROZEN")
                                 : QCoreApplication::translate("window", "ACTIVE")};
  if (facts.incremental) names << QCoreApplication::translate("window", "INC");
  if (facts.nearby) names << QCoreApplication::translate("window", "NEARBY");
  return names;
}

SubmapFilter::SubmapFilter(const QString& text) {
  static const QRegularExpression space(QStringLiteral("\\s+"));
  for (const QString& word : text.toLower().split(space, Qt::SkipEmptyParts)) words_.push_back(word);
}

bool SubmapFilter::matches(const SubmapFacts& facts) const {
  return std::all_of(words_.begin(), words_.end(),
                     [&facts](const QString& w) { return wordMatches(w, facts); });
}

}  // namespace mapwright::ui
