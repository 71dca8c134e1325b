#include "edit/draft.h"

#include <QJsonDocument>

namespace mapwright::edit {
namespace {

constexpr int kFormat = 1;

}  // namespace

QByteArray draftBytes(const DraftIdentity& of, const QDateTime& made, const QJsonArray& changes) {
  const QJsonObject frame{{QStringLiteral("mapwright_draft"), kFormat},
                          {QStringLiteral("address"), of.address},
                          {QStringLiteral("map"), of.map},
                          {QStringLiteral("kind"), of.kind},
                          {QStringLiteral("made_ms"), double(made.toMSecsSinceEpoch())},
                          {QStringLiteral("changes"), changes}};
  return QJsonDocument(frame).toJson(QJsonDocument::Compact);
}

std::optional<DraftFrame> draftFrame(const QByteArray& bytes) {
  const QJsonObject frame = QJsonDocument::fromJson(bytes).object();
  const auto text = [&](const char* name) { return frame.value(QLatin1String(name)); };
  if (frame.value(QLatin1String("mapwright_draft")).toInt() != kFormat || !text("address").isString() ||
      !text("map").isString() || !text("kind").isString() ||
      !frame.value(QLatin1String("made_ms")).isDouble() || !frame.value(QLatin1String("changes")).isArray()) {
    return std::nullopt;
  }
  DraftFrame read;
  read.of = {text("address").toString(), text("map").toString(), text("kind").toString()};
  read.made = QDateTime::fromMSecsSinceEpoch(qint64(frame.value(QLatin1String("made_ms")).toDouble()));
  read.changes = frame.value(QLatin1String("changes")).toArray();
  return read;
}

}  // namespace mapwright::edit
