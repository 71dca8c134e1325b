// Random edits of two people, merged by the program and by a plain model that shares no code with it. The
// cases by name are those in which the command line and the window once merged differently.
#include <map>
#include <optional>
#include <random>
#include <set>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include "overlays/editing_document.h"
#include "overlays/overlay_merge.h"
#include "test_program.h"

namespace test_merge_model {

using namespace mapwright::overlays;

namespace {

// --- The model. A feature is its members and properties by their name, with their values as JSON.

using Members = std::map<std::string, QByteArray>;
const std::string kProperties = "properties";

QByteArray jsonOf(const QJsonValue& value) {
  const QByteArray list = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
  return list.mid(1, list.size() - 2);
}

Members membersOf(const QJsonObject& object) {
  Members members;
  for (auto member = object.begin(); member != object.end(); ++member) {
    const std::string name = member.key().toStdString();
    if (name == "features") continue;
    if (name != kProperties || !member->isObject()) {
      members[name] = jsonOf(*member);
      continue;
    }
    const QJsonObject properties = member->toObject();
    for (auto property = properties.begin(); property != properties.end(); ++property)
      members[kProperties + "." + property.key().toStdString()] = jsonOf(*property);
  }
  return members;
}

struct Plain {
  std::vector<Members> features;
  std::vector<std::string> texts;  // of the features, as written
  Members collection;
};

Plain plain(const OverlayDocument& document) {
  const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(document.text()));
  Plain plain;
  if (json.isObject()) plain.collection = membersOf(json.object());
  plain.collection.try_emplace("type", "\"FeatureCollection\"");
  for (const QJsonValue& feature :
       json.isArray() ? json.array() : json.object()[QStringLiteral("features")].toArray())
    plain.features.push_back(membersOf(feature.toObject()));
  for (const Feature& feature : document.features()) plain.texts.push_back(feature.text());
  return plain;
}

QByteArray valueOf(const Members& feature, const std::string& name) {
  const auto found = feature.find(name);
  return found == feature.end() ? QByteArray() : found->second;
}
Members withoutId(Members feature) {
  feature.erase("id");
  return feature;
}

/// Without a place it has no shape, and so no type.
QByteArray kindOf(const Members& feature) {
  return valueOf(feature, "geometry").isEmpty() ? QByteArray() : valueOf(feature, "properties.lineType");
}

using Pairs = std::map<std::size_t, std::size_t>;

/// The same features in a and b. `guess`: also by name and kind, or by place.
Pairs pairsOf(const Plain& a, const Plain& b, std::set<std::size_t> in_a, std::set<std::size_t> in_b,
              bool guess) {
  Pairs pairs;
  const auto pair = [&](const auto& same, bool lacks_id, bool unique) {
    const std::set<std::size_t> left = in_a, right = in_b;
    for (const std::size_t i : left) {
      const auto count = [&](const Plain& of, const std::set<std::size_t>& among) {
        return std::count_if(among.begin(), among.end(), [&](std::size_t k) { return same(a, i, of, k); });
      };
      if (unique && (count(a, left) != 1 || count(b, right) != 1)) continue;
      for (const std::size_t k : right) {
        if (!in_b.contains(k) || !same(a, i, b, k)) continue;
        if (lacks_id && !valueOf(a.features[i], "id").isEmpty() && !valueOf(b.features[k], "id").isEmpty())
          continue;
        pairs[i] = k;
        in_a.erase(i);
        in_b.erase(k);
        break;
      }
    }
  };
  const auto equal = [](const std::string& name) {
    return [name](const Plain& of_a, std::size_t i, const Plain& of_b, std::size_t k) {
      const QByteArray value = valueOf(of_a.features[i], name);
      return !value.isEmpty() && value == valueOf(of_b.features[k], name);
    };
  };
  pair([](const Plain& of_a, std::size_t i, const Plain& of_b,
          std::size_t k) { return of_a.texts[i] == of_b.texts[k]; },
       false, false);
  pair(equal("id"), false, false);
  pair([](const Plain& of_a, std::size_t i, const Plain& of_b,
          std::size_t k) { return withoutId(of_a.features[i]) == withoutId(of_b.features[k]); },
       true, false);
  if (!guess) return pairs;
  pair(
      [&](const Plain& of_a, std::size_t i, const Plain& of_b, std::size_t k) {
        const Members &one = of_a.features[i], &other = of_b.features[k];
        return !valueOf(one, "properties.name").isEmpty() &&
               valueOf(one, "properties.name") == valueOf(other, "properties.name") &&
               kindOf(one) == kindOf(other);
      },
      true, true);
  pair(equal("geometry"), true, true);
  return pairs;
}

struct Merged {
  std::vector<Members> features;
  std::vector<std::string> texts;  // of the features that keep their bytes; empty: others
  Members collection;
  std::multiset<std::string> conflicts;  // "id part"
};

/// Each member for itself; what both changed differently is theirs for the time being, and a conflict.
Members mergedMembers(const Members& base, const Members& mine, const Members& theirs,
                      const std::function<void(const std::string&)>& conflict) {
  const auto changed = [&](const Members& now, bool whole) {
    std::set<std::string> names;
    for (const Members* side : {&base, &now}) {
      for (const auto& [name, value] : *side) {
        const bool property = name.rfind(kProperties, 0) == 0;
        if (property && valueOf(base, name) != valueOf(now, name) && (!whole || name == kProperties))
          names.insert(name);
      }
    }
    return names;
  };
  // Properties that are something else than an object on one side are one value.
  const auto of = [&](const Members& now) {
    Members properties;
    for (const auto& [name, value] : now) {
      if (name.rfind(kProperties, 0) == 0) properties[name] = value;
    }
    return properties;
  };
  const bool other_kind = !changed(mine, true).empty() || !changed(theirs, true).empty();
  const bool whole = other_kind && of(mine) != of(base) && of(theirs) != of(base);
  Members merged = theirs;
  std::set<std::string> names;
  for (const auto& [name, value] : base) names.insert(name);
  for (const auto& [name, value] : mine) names.insert(name);
  for (const std::string& name : names) {
    if (whole && name.rfind(kProperties, 0) == 0) continue;
    const QByteArray was = valueOf(base, name), now = valueOf(mine, name), other = valueOf(theirs, name);
    if (now == was || now == other) continue;
    if (other != was) {
      conflict(name);
    } else if (now.isEmpty()) {
      merged.erase(name);
    } else {
      merged[name] = now;
    }
  }
  if (whole && of(mine) != of(theirs)) conflict(kProperties);
  return merged;
}

Merged modelMerge(const Plain& base, const Plain& mine, const Plain& theirs) {
  const auto all = [](const Plain& of) {
    std::set<std::size_t> indices;
    for (std::size_t i = 0; i < of.features.size(); ++i) indices.insert(i);
    return indices;
  };
  const Pairs to_mine = pairsOf(base, mine, all(base), all(mine), true);
  const Pairs to_theirs = pairsOf(base, theirs, all(base), all(theirs), true);
  std::set<std::size_t> my_new = all(mine), their_new = all(theirs);
  for (const auto& [i, k] : to_mine) my_new.erase(k);
  for (const auto& [i, k] : to_theirs) their_new.erase(k);
  const Pairs both_new = pairsOf(mine, theirs, my_new, their_new, false);
  for (const auto& [i, k] : both_new) my_new.erase(i);

  Merged merged;
  const auto conflict = [&](const Members& about, const std::string& part) {
    merged.conflicts.insert(valueOf(about, "id").toStdString() + ' ' + part);
  };
  std::map<std::size_t, std::optional<Members>> now;  // by their index
  for (std::size_t i = 0; i < base.features.size(); ++i) {
    const Members& was = base.features[i];
    const auto here = to_mine.find(i), there = to_theirs.find(i);
    const Members* const my = here == to_mine.end() ? nullptr : &mine.features[here->second];
    const Members* const their = there == to_theirs.end() ? nullptr : &theirs.features[there->second];
    if (my && their) {
      now[there->second] =
          mergedMembers(was, *my, *their, [&](const std::string& part) { conflict(was, part); });
    } else if (my) {
      if (*my != was) conflict(was, "");
    } else if (their) {
      const bool only_id = valueOf(was, "id").isEmpty() && withoutId(*their) == was;
      if (*their == was || only_id) {
        now[there->second] = std::nullopt;
      } else {
        conflict(was, "");
      }
    }
  }
  for (const auto& [i, k] : both_new)
    now[k] = mergedMembers({}, mine.features[i], theirs.features[k],
                           [&](const std::string& part) { conflict(mine.features[i], part); });
  for (std::size_t k = 0; k < theirs.features.size(); ++k) {
    const auto found = now.try_emplace(k, theirs.features[k]).first;
    if (!found->second) continue;
    merged.features.push_back(*found->second);
    merged.texts.push_back(*found->second == theirs.features[k] ? theirs.texts[k] : std::string());
  }
  for (const std::size_t i : my_new) {
    merged.features.push_back(mine.features[i]);
    merged.texts.push_back(mine.texts[i]);
  }
  merged.collection = mergedMembers(base.collection, mine.collection, theirs.collection,
                                    [&](const std::string& part) { conflict({}, part); });
  return merged;
}

// --- Random documents and edits of them, as text.

class Author {
 public:
  explicit Author(unsigned seed) : random_(seed) {}

  int below(int end) { return int(random_() % unsigned(end)); }
  bool oneIn(int many) { return below(many) == 0; }
  std::string from(const std::vector<std::string>& choices) {
    return choices[std::size_t(below(int(choices.size())))];
  }

  /// A feature as the texts of its members; "properties.…" are its properties.
  using Texts = std::map<std::string, std::string>;
  struct Document {
    std::vector<Texts> features;
    Texts collection;
    bool list = false;  // without a collection around it
  };

  std::string geometry() {
    return R"({"type":"LineString","coordinates":)" +
           from({"[[0,0],[1,0]]", "[[0,0],[1,1.50]]", "[[5,5],[6,6]]", "[[7,7],[8,9]]"}) + "}";
  }
  std::string valueOf(const std::string& name) {
    if (name == "geometry") return geometry();
    if (name == "properties") return from({"null", "7"});
    if (name == "properties.name") return from({R"("A")", R"("B")", R"("C")", R"("\u0041")"});
    return from({"1", "1.0", "2", "[ 3]", "1.50", "1.5", "null"});
  }
  Texts feature() {
    Texts texts{{"geometry", geometry()}, {"properties.lineType", from({"1", "2"})}};
    if (!oneIn(3)) texts["id"] = from({R"("a")", R"("b")", R"("c")", R"("d")", "7"});
    if (!oneIn(3)) texts["properties.name"] = valueOf("properties.name");
    if (oneIn(2)) texts["properties.speed"] = valueOf("properties.speed");
    if (oneIn(3)) texts["future"] = valueOf("future");
    return texts;
  }
  Document document() {
    Document document;
    for (int i = below(5); i > 0; --i) document.features.push_back(feature());
    document.collection["type"] = R"("FeatureCollection")";
    if (oneIn(2)) document.collection["crs"] = valueOf("crs");
    if (oneIn(2)) document.collection["properties.defaultRackWidth"] = valueOf("x");
    document.list = oneIn(12);
    return document;
  }

  void change(Texts& texts, const std::vector<std::string>& names) {
    const std::string name = from(names);
    if (name == "properties") {
      std::erase_if(texts, [](const auto& member) { return member.first.rfind("properties", 0) == 0; });
      texts[name] = valueOf(name);
      return;
    }
    if (name.rfind("properties.", 0) == 0) texts.erase("properties");
    if (oneIn(4)) {
      texts.erase(name);
    } else {
      texts[name] = valueOf(name);
    }
  }
  /// The same values in another notation.
  static void writeOtherwise(Texts& texts) {
    static const std::map<std::string, std::string> same{
        {"1", "1.0"}, {"1.5", "1.50"}, {"[ 3]", "[3.0]"}, {R"("A")", R"("\u0041")"}};
    for (auto& [name, value] : texts) {
      for (const auto& [one, other] : same) {
        if (value == one || value == other) {
          value = value == one ? other : one;
          break;
        }
      }
    }
  }
  Document edited(Document document) {
    auto& features = document.features;
    for (int steps = below(4); steps > 0; --steps) {
      const std::size_t at = features.empty() ? 0 : std::size_t(below(int(features.size())));
      switch (below(11)) {
        case 0:
        case 1:
          features.push_back(feature());
          break;
        case 2:
          if (!features.empty()) features.erase(features.begin() + long(at));
          break;
        case 3:
          if (!features.empty()) std::swap(features[at], features[0]);
          break;
        case 4:
          if (!features.empty()) features.push_back(features[at]);
          break;
        case 5:
          if (!features.empty()) features[at].try_emplace("id", from({R"("n1")", R"("n2")"}));
          break;
        case 6:
          if (!features.empty()) writeOtherwise(features[at]);
          break;
        case 7:
          change(document.collection,
                 {"crs", "properties.defaultRackWidth", "properties.defaultRackDepth", "properties"});
          break;
        default:
          if (!features.empty())
            change(features[at], {"geometry", "properties.name", "properties.speed", "properties.mac",
                                  "future", "past", "properties"});
      }
    }
    return document;
  }

  static std::string objectOf(const Texts& texts, const std::string& last = {}) {
    std::string members, properties;
    const auto add = [](std::string& to, const std::string& name, const std::string& value) {
      to += (to.empty() ? "\"" : ",\"") + name + "\":" + value;
    };
    for (const auto& [name, value] : texts) {
      if (name.rfind("properties.", 0) == 0) {
        add(properties, name.substr(11), value);
      } else {
        add(members, name, value);
      }
    }
    if (!properties.empty()) add(members, "properties", '{' + properties + '}');
    return '{' + members + (last.empty() ? last : (members.empty() ? "" : ",") + last) + '}';
  }
  static OverlayDocument read(const Document& document) {
    std::string features;
    for (const Texts& feature : document.features)
      features += (features.empty() ? "" : ",") + objectOf(feature);
    auto read = OverlayDocument::read(document.list
                                          ? '[' + features + ']'
                                          : objectOf(document.collection, "\"features\":[" + features + "]"));
    if (!read) qFatal("no overlays: %s", features.c_str());
    return std::move(*read);
  }

 private:
  std::mt19937 random_;
};

std::string shown(const OverlayDocument& base, const OverlayDocument& mine, const OverlayDocument& theirs) {
  return "\nbase   " + base.text() + "\nmine   " + mine.text() + "\ntheirs " + theirs.text();
}

std::multiset<std::string> conflictsOf(const OverlayMerge& merged) {
  std::multiset<std::string> conflicts;
  for (const OverlayConflict& conflict : merged.conflicts) {
    const std::string id = conflict.id.empty()  ? ""
                           : conflict.id == "7" ? conflict.id
                                                : '"' + conflict.id + '"';
    conflicts.insert(id + ' ' + conflict.part.text());
  }
  return conflicts;
}

/// As the window merges it.
OverlayMerge windowMerge(const OverlayDocument& base, const OverlayDocument& mine,
                         const OverlayDocument& theirs) {
  EditingDocument document(theirs);
  document.restoreDraft(base, mine);
  OverlayMerge merged;
  for (const EditingDocument::Conflict& conflict : document.conflicts()) {
    const auto &here = document.find(conflict.first), &there = document.findBase(conflict.first);
    const bool whole = conflict.first == kCollectionKey;
    const auto& was = document.beforeConflict(conflict.first);
    merged.conflicts.push_back({whole   ? ""
                                : was   ? was->id()
                                : here  ? here->id()
                                : there ? there->id()
                                        : "",
                                "",
                                conflict.second,
                                {},
                                document.mineOf(conflict),
                                document.theirsOf(conflict)});
  }
  for (const EditingDocument::Conflict& conflict : document.conflicts()) document.useTheirs(conflict);
  merged.document = document.mine();
  return merged;
}

}  // namespace

class MergeModelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theModelMergesInTheSameWay() {
    for (unsigned seed = 0; seed < 2000; ++seed) {
      Author author(seed);
      const Author::Document first = author.document();
      const OverlayDocument base = Author::read(first), mine = Author::read(author.edited(first)),
                            theirs = Author::read(author.edited(first));
      const Merged model = modelMerge(plain(base), plain(mine), plain(theirs));
      const auto check = [&](const OverlayMerge& merged, const char* whose) {
        const std::string about = whose + shown(base, mine, theirs) + "\nmerged " + merged.document.text();
        const Plain result = plain(merged.document);
        QVERIFY2(result.features == model.features, about.c_str());
        QVERIFY2(result.collection == model.collection, about.c_str());
        QVERIFY2(conflictsOf(merged) == model.conflicts, about.c_str());
        for (std::size_t i = 0; i < model.texts.size(); ++i)
          QVERIFY2(model.texts[i].empty() || model.texts[i] == result.texts[i], about.c_str());
      };
      check(merge(base, mine, theirs), "command line");
      check(windowMerge(base, mine, theirs), "window");
      if (QTest::currentTestFailed()) return;
    }
  }

  void whatTheyLeftAloneIsMergedAsIfItWereNew() {
    for (unsigned seed = 0; seed < 1000; ++seed) {
      Author author(seed);
      const Author::Document first = author.document();
      const OverlayDocument base = Author::read(first), mine = Author::read(author.edited(first));
      const OverlayMerge merged = merge(base, mine, Author::read(first));
      const std::string about = shown(base, mine, base) + "\nmerged " + merged.document.text();
      QVERIFY2(merged.document.text() == windowMerge(base, mine, base).document.text(), about.c_str());
      QVERIFY2(merged.theirs.empty() && merged.conflicts.empty(), about.c_str());
    }
  }

  void whatWasMergedInTwoWays_data() {
    QTest::addColumn<QString>("base");
    QTest::addColumn<QString>("mine");
    QTest::addColumn<QString>("theirs");
    QTest::addColumn<QString>("merged");
    QTest::addColumn<QString>("conflicts");
    // Was a conflict on the command line. It is how a robot keeps what I sent, with a member of its own.
    QTest::newRow("they added more to what both added") << ""
                                                        << R"({"id":"a","v":1})"
                                                        << R"({"id":"a","v":1,"w":2})"
                                                        << R"({"id":"a","v":1,"w":2})"
                                                        << "";
    // Was a conflict in both: nobody set that member differently.
    QTest::newRow("I added more to what both added") << ""
                                                     << R"({"id":"a","v":1,"w":2})"
                                                     << R"({"id":"a","v":1})"
                                                     << R"({"id":"a","v":1,"w":2})"
                                                     << "";
    QTest::newRow("both added it differently") << ""
                                               << R"({"id":"a","v":1})"
                                               << R"({"id":"a","v":2})"
                                               << R"({"id":"a","v":2})"
                                               << "v";
    // Was there twice in the window.
    QTest::newRow("both added the same without an id") << ""
                                                       << R"({"v":1})"
                                                       << R"({"v":1})"
                                                       << R"({"v":1})"
                                                       << "";
    QTest::newRow("the robot gave it an id") << ""
                                             << R"({"v":1})"
                                             << R"({"v":1,"id":7})"
                                             << R"({"v":1,"id":7})"
                                             << "";
    // Was there once on the command line: one of mine was lost.
    QTest::newRow("I added two, they one") << ""
                                           << R"({"v":1},{"v":1})"
                                           << R"({"v":1})"
                                           << R"({"v":1},{"v":1})"
                                           << "";
    // Left empty properties behind on the command line.
    QTest::newRow("I removed the last property") << R"({"id":"a","properties":{"x":1}})"
                                                 << R"({"id":"a"})"
                                                 << R"({"id":"a","properties":{"x":1},"v":1})"
                                                 << R"({"id":"a","v":1})"
                                                 << "";
    // The window kept my notation of what they had set to the same value.
    QTest::newRow("both set the same value") << R"({"id":"a","v":1,"w":1})"
                                             << R"({"id":"a","v":1.5,"w":2})"
                                             << R"({"id":"a","v":1.50,"w":1})"
                                             << R"({"id":"a","v":1.50,"w":2})"
                                             << "";
    // Were several conflicts; taking theirs in the window lost all properties.
    QTest::newRow("no object here, changed there") << R"({"id":"a","properties":{"x":1,"y":1}})"
                                                   << R"({"id":"a","properties":null})"
                                                   << R"({"id":"a","properties":{"x":2,"y":1}})"
                                                   << R"({"id":"a","properties":{"x":2,"y":1}})"
                                                   << "properties";
    QTest::newRow("changed here, no object there") << R"({"id":"a","properties":{"x":1,"y":1}})"
                                                   << R"({"id":"a","properties":{"x":2,"y":1}})"
                                                   << R"({"id":"a","properties":null})"
                                                   << R"({"id":"a","properties":null})"
                                                   << "properties";
  }
  void whatWasMergedInTwoWays() {
    QFETCH(const QString, base);
    QFETCH(const QString, mine);
    QFETCH(const QString, theirs);
    QFETCH(const QString, merged);
    QFETCH(const QString, conflicts);
    const auto read = [](const QString& features) {
      return *OverlayDocument::read(R"({"features":[)" + features.toStdString() + "]}");
    };
    for (const OverlayMerge& result :
         {merge(read(base), read(mine), read(theirs)), windowMerge(read(base), read(mine), read(theirs))}) {
      QCOMPARE(result.document.text(), read(merged).text());
      QStringList parts;
      for (const OverlayConflict& conflict : result.conflicts)
        parts << QString::fromStdString(conflict.part.text());
      QCOMPARE(parts.join(QLatin1Char(' ')), conflicts);
    }
  }

  void mineIsKeptWholeWhereTheirPropertiesAreNoObject() {
    const std::string mine = R"({"id":"a","properties":{"x":2,"y":1}})";
    EditingDocument document(*OverlayDocument::read(R"([{"id":"a","properties":{"x":1,"y":1}}])"));
    document.change({{0, document.find(0), Feature(mine)}});
    document.rebase(*OverlayDocument::read(R"([{"id":"a","properties":null}])"));
    QCOMPARE(document.conflicts().size(), std::size_t(1));
    QCOMPARE(document.find(0)->text(), mine);
  }
};

}  // namespace test_merge_model

MAPWRIGHT_TEST(test_merge_model, MergeModelTest, Nothing)
#include "test_merge_model.moc"
