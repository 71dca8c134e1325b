// A picture held against those that are accepted of it, and why it differs. Blocks: reads their files.
#pragma once

#include <optional>

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "compare/comparison.h"
#include "suite/facts.h"
#include "suite/outcome.h"

namespace mapwright::suite {

struct Judgement {
  Verdict verdict = Verdict::Failed;
  QString sentence;                               // why they could not be compared
  QString expected;                               // the nearest picture
  std::optional<compare::Comparison> comparison;  // with it
  bool unreadable() const { return verdict == Verdict::Failed; }
};
/// Precondition: there is an accepted picture.
Judgement judge(const QStringList& accepted, const QString& actual, const compare::Allowed& allowed);

/// "a.json" of "a.png".
QString factsBeside(const QString& picture);
/// The error is a sentence without the name of the file.
tl::expected<Facts, QString> factsIn(const QString& path);

/// Those beside the nearest picture, if they can be read and are of it.
std::optional<Facts> expectedFacts(const Judgement& judgement);

/// What is to be said of a view that differs, joined with the facts that changed since the nearest of its
/// pictures, if there are facts of that one. A note if they cannot be read. Precondition: they were compared.
void explain(const Judgement& judgement, const Facts& facts, ViewOutcome& outcome);

}  // namespace mapwright::suite
