#include "suite/read_suite.h"

#include <cmath>
#include <map>
#include <optional>
#include <yaml-cpp/yaml.h>

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <QStringList>

#include "words/listed.h"
#include "words/qt_plain.h"
#include "yaml/read_yaml.h"

namespace mapwright::suite {
namespace {

struct SuiteText {
  Q_DECLARE_TR_FUNCTIONS(SuiteText)
};

constexpr int kMostEntries = 1'000;
constexpr std::size_t kLongestValue = 10'000;
constexpr std::size_t kMostValueBytes = std::size_t(64) << 20;  // of all views, defaults counted in each
constexpr double kLargestLimitM = 10'000;
constexpr int kLongestName = 120;  // in bytes of UTF-8; more is added for the files

Position positionOf(const YAML::Mark& mark) {
  return mark.is_null() ? Position{} : Position{mark.line + 1, mark.column + 1};
}

/// Why reading ends; what the parser itself throws is caught in the same place.
struct Refused {
  QString sentence;
};
Refused refusedAt(const YAML::Mark& mark, const QString& sentence) {
  return {atPosition(positionOf(mark), sentence)};
}

QString shown(const std::string& text) { return words::plainName(text).left(80); }

Refused twiceAt(const YAML::Node& key) {
  return refusedAt(key.Mark(), SuiteText::tr("The key \"%1\" stands here twice.").arg(shown(key.Scalar())));
}
QString noScalarText(const QString& key) { return SuiteText::tr("%1 must be a text or a number.").arg(key); }
QString noValueText(const QString& key) { return SuiteText::tr("%1 has no value.").arg(key); }
QString tooLongText(const QString& key) {
  return SuiteText::tr("%1 is too long: at most %2 entries and %3 bytes.")
      .arg(key)
      .arg(kMostEntries)
      .arg(kLongestValue);
}

std::string scalar(const YAML::Node& node, const QString& key) {
  if (!node.IsScalar()) throw refusedAt(node.Mark(), noScalarText(key));
  return node.Scalar();
}

/// [1, 2] as "1,2".
std::string joined(const YAML::Node& node, const QString& key) {
  // Written once, it may stand in every view.
  const auto tooLong = [&] { return refusedAt(node.Mark(), tooLongText(key)); };
  if (!node.IsSequence()) {
    const std::string text = scalar(node, key);
    if (text.empty()) throw refusedAt(node.Mark(), noValueText(key));
    if (text.size() > kLongestValue) throw tooLong();
    return text;
  }
  std::string text;
  int entries = 0;
  for (const YAML::Node& item : node) {
    text += (text.empty() ? "" : ",") + scalar(item, key);
    if (++entries > kMostEntries || text.size() > kLongestValue) throw tooLong();
  }
  if (text.empty()) throw refusedAt(node.Mark(), noValueText(key));
  return text;
}

bool switchOf(const YAML::Node& node, const QString& key) {
  const std::string text = scalar(node, key);
  if (text != "true" && text != "false")
    throw refusedAt(node.Mark(), SuiteText::tr("%1 must be true or false.").arg(key));
  return text == "true";
}

double numberOf(const YAML::Node& node, const QString& key, double most) {
  bool ok = false;
  const double number = QString::fromStdString(scalar(node, key)).toDouble(&ok);
  if (!ok || !(number >= 0 && number <= most))
    throw refusedAt(node.Mark(), SuiteText::tr("%1 must be a number from 0 to %2.").arg(key).arg(most));
  return number;
}

int wholeOf(const YAML::Node& node, const QString& key, int most) {
  const double number = numberOf(node, key, most);
  if (number != std::floor(number))
    throw refusedAt(node.Mark(), SuiteText::tr("%1 must be a whole number.").arg(key));
  return int(number);
}

Quality qualityOf(const YAML::Node& node) {
  if (node.IsNull() || (node.IsScalar() && node.Scalar() == "false")) return {};
  if (!node.IsMap())
    throw refusedAt(node.Mark(), SuiteText::tr("quality must be limits with their values, or false."));
  Quality quality;
  std::set<std::string> seen;
  for (const auto& pair : node) {
    std::string key = scalar(pair.first, SuiteText::tr("A key"));
    const QString shown_key = shown(key);
    std::replace(key.begin(), key.end(), '-', '_');
    if (!seen.insert(key).second) throw twiceAt(pair.first);
    if (key == "closures_over_m") {
      quality.closures_over_m = numberOf(pair.second, shown_key, kLargestLimitM);
    } else if (key == "closures_at_least") {
      quality.closures_at_least = wholeOf(pair.second, shown_key, Quality::kMostClosures);
    } else if (key == "disagreement_over") {
      quality.disagreement_over = numberOf(pair.second, shown_key, 1);
    } else if (key == "tolerance_cells") {
      quality.tolerance_cells = wholeOf(pair.second, shown_key, Quality::kMostTolerance);
    } else {
      throw refusedAt(
          pair.first.Mark(),
          SuiteText::tr("There is no key \"%1\" of quality. Known: %2.")
              .arg(shown_key,
                   QStringLiteral("closures_over_m, disagreement_over, tolerance_cells, closures_at_least")));
    }
  }
  if (!quality.asked())
    throw refusedAt(node.Mark(), SuiteText::tr("quality needs closures_over_m, disagreement_over or both."));
  if (seen.contains("closures_at_least") && !quality.closures_over_m)
    throw refusedAt(node.Mark(), SuiteText::tr("closures_at_least means nothing without closures_over_m."));
  if (seen.contains("tolerance_cells") && !quality.disagreement_over)
    throw refusedAt(node.Mark(), SuiteText::tr("tolerance_cells means nothing without disagreement_over."));
  return quality;
}

/// The names of files are made of it.
QString nameOf(const YAML::Node& node) {
  const std::string text = scalar(node, QStringLiteral("name"));
  const QString name = QString::fromStdString(text);
  if (name.trimmed().isEmpty())
    throw refusedAt(node.Mark(), SuiteText::tr("The name of this view is empty."));
  if (name.startsWith(QLatin1Char('.')) || name.contains(QLatin1Char('/')) ||
      name.contains(QLatin1Char('\\'))) {
    throw refusedAt(node.Mark(),
                    SuiteText::tr("The name \"%1\" would leave the folder or be hidden in it: leave out "
                                  "/, \\ and a dot at the beginning.")
                        .arg(shown(text)));
  }
  if (words::plainName(name) != name)
    throw refusedAt(node.Mark(),
                    SuiteText::tr("The name \"%1\" has blanks around it, or characters that cannot be seen.")
                        .arg(shown(text)));
  if (text.size() > std::size_t(kLongestName))
    throw refusedAt(node.Mark(), SuiteText::tr("The name \"%1\" is too long for a file: at most %2 bytes.")
                                     .arg(shown(text))
                                     .arg(kLongestName));
  return name;
}

void setOption(View& view, ViewOption option) {
  std::erase_if(view.options, [&](const ViewOption& other) { return other.name == option.name; });
  view.options.push_back(std::move(option));
}

QString knownKeys(const KnownOptions& known) {
  QStringList keys{QStringLiteral("mask"), QStringLiteral("max_differing"), QStringLiteral("name"),
                   QStringLiteral("quality"), QStringLiteral("tolerance")};
  for (const auto* names : {&known.values, &known.switches}) {
    for (const std::string& name : *names) keys << QString::fromStdString(name);
  }
  keys.sort();
  return words::listed(keys);
}

/// Adds what `node` says to `view`.
void readKeys(const YAML::Node& node, const KnownOptions& known, bool is_view, View& view) {
  std::set<std::string> seen;
  for (const auto& pair : node) {
    const YAML::Mark mark = pair.first.Mark();
    const std::string key = scalar(pair.first, SuiteText::tr("A key"));
    const QString shown_key = shown(key);
    std::string option = key;
    std::replace(option.begin(), option.end(), '_', '-');
    if (!seen.insert(option).second) throw twiceAt(pair.first);
    if (key == "name") {
      if (!is_view)
        throw refusedAt(mark, SuiteText::tr("A name cannot be a default: each view has its own."));
      view.name = nameOf(pair.second);
      view.at = positionOf(pair.second.Mark());
    } else if (key == "mask") {
      view.mask = QString::fromStdString(joined(pair.second, shown_key));
    } else if (key == "tolerance") {
      view.tolerance = wholeOf(pair.second, shown_key, 255);
    } else if (key == "quality") {
      view.quality = qualityOf(pair.second);
    } else if (option == "max-differing") {
      view.max_differing_percent = numberOf(pair.second, shown_key, 100);
    } else if (known.switches.contains(option)) {
      const bool on = switchOf(pair.second, shown_key);
      std::erase_if(view.options, [&](const ViewOption& other) { return other.name == option; });
      if (on) view.options.push_back({option, {}, true, positionOf(mark)});
    } else if (known.values.contains(option)) {
      setOption(view, {option, joined(pair.second, shown_key), false, positionOf(pair.second.Mark())});
    } else {
      throw refusedAt(
          mark,
          SuiteText::tr("There is no key \"%1\" of a view. Known: %2.").arg(shown_key, knownKeys(known)));
    }
  }
}

/// Files on some systems do not tell large letters from small ones, and some compose accents otherwise.
QString folded(const QString& name) { return name.normalized(QString::NormalizationForm_KC).toCaseFolded(); }

/// Refuses names whose files would be the same, or the same as another view's accepted variants.
void lookForTwins(const Suite& suite) {
  static const QRegularExpression variant(QStringLiteral("^(.+)\\.[0-9]+$"));
  QHash<QString, const View*> by_name;
  const auto twins = [](const View& view, const View& other, const QString& sentence) {
    throw Refused{atPosition(view.at, sentence.arg(view.name, other.name, QString::number(other.at.line)))};
  };
  for (const View& view : suite.views) {
    const View*& other = by_name[folded(view.name)];
    if (other != nullptr)
      twins(
          view, *other,
          SuiteText::tr("The view \"%1\" is called like \"%2\" in line %3: their files would be the same."));
    other = &view;
  }
  for (const View& view : suite.views) {
    const auto match = variant.match(folded(view.name));
    if (!match.hasMatch()) continue;
    if (const View* const other = by_name.value(match.captured(1)))
      twins(view, *other,
            SuiteText::tr("The picture of the view \"%1\" would be a variant of \"%2\" in line %3."));
  }
}

Suite suiteIn(const YAML::Node& root, const KnownOptions& known) {
  if (!root.IsMap()) throw Refused{SuiteText::tr("This is no suite: it has no views.")};
  YAML::Node views, defaults;
  std::set<std::string> seen;
  for (const auto& pair : root) {
    const std::string key = scalar(pair.first, SuiteText::tr("A key"));
    if (!seen.insert(key).second) throw twiceAt(pair.first);
    if (key == "views") {
      views.reset(pair.second);
    } else if (key == "defaults") {
      defaults.reset(pair.second);
    } else {
      throw refusedAt(pair.first.Mark(),
                      SuiteText::tr("There is no key \"%1\" here, only defaults and views.").arg(shown(key)));
    }
  }
  View usual;
  if (defaults.IsDefined() && !defaults.IsNull()) {
    if (!defaults.IsMap())
      throw refusedAt(defaults.Mark(), SuiteText::tr("The defaults must be keys with their values."));
    readKeys(defaults, known, false, usual);
  }
  if (!views.IsDefined() || !views.IsSequence() || views.size() == 0)
    throw refusedAt(views.Mark(), SuiteText::tr("This is no suite: it has no views."));
  if (views.size() > kMostViews)
    throw refusedAt(views.Mark(), SuiteText::tr("There are more than %1 views.").arg(kMostViews));
  Suite suite;
  suite.views.reserve(views.size());
  std::size_t bytes = 0;
  for (const YAML::Node& node : views) {
    if (!node.IsMap()) throw refusedAt(node.Mark(), SuiteText::tr("A view must be keys with their values."));
    View view = usual;
    view.at = positionOf(node.Mark());
    readKeys(node, known, true, view);
    if (view.name.isEmpty()) throw refusedAt(node.Mark(), SuiteText::tr("This view has no name."));
    for (const ViewOption& option : view.options) bytes += option.value.size();
    if (bytes > kMostValueBytes)
      throw refusedAt(
          node.Mark(),
          SuiteText::tr("The values of all views up to here are more than %1 MiB, defaults counted in each.")
              .arg(kMostValueBytes >> 20));
    suite.views.push_back(std::move(view));
  }
  lookForTwins(suite);
  return suite;
}

QString sentenceOf(const yaml::Broken& broken) {
  const auto what = [&] {
    switch (broken.code) {
      case yaml::Broken::Code::TooLong:
        return SuiteText::tr("It is larger than %1 MiB.").arg(kMostSuiteBytes >> 20);
      case yaml::Broken::Code::TooMuch:
        return SuiteText::tr("It has too many values; an alias counts as what it stands for.");
      case yaml::Broken::Code::TooDeep:
        return SuiteText::tr("It is nested too deeply.");
      case yaml::Broken::Code::NotYaml:
        break;
    }
    return SuiteText::tr("It is not YAML: %1.").arg(shown(broken.detail));
  };
  return atPosition({broken.line, broken.column}, what());
}

}  // namespace

QString atPosition(Position at, const QString& sentence) {
  if (at.line == 0) return sentence;
  return SuiteText::tr("Line %1, column %2: %3")
      .arg(QString::number(at.line), QString::number(at.column), sentence);
}

tl::expected<Suite, QString> readSuite(const std::string& text, const KnownOptions& known) {
  const auto document = yaml::readYaml(text, {.most_bytes = kMostSuiteBytes});
  if (!document) return tl::make_unexpected(sentenceOf(document.error()));
  try {
    if (document->next)
      throw refusedAt(*document->next,
                      SuiteText::tr("A second document begins here: a suite is one. Leave out the ---."));
    return suiteIn(document->root, known);
  } catch (const Refused& refused) {
    return tl::make_unexpected(refused.sentence);
  } catch (const YAML::Exception& broken) {
    return tl::make_unexpected(
        atPosition(positionOf(broken.mark), SuiteText::tr("It is not YAML: %1.").arg(shown(broken.msg))));
  }
}

}  // namespace mapwright::suite
