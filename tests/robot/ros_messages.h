// Messages of rosbridge for tests, by both wires.
#pragma once

#include <memory>
#include <utility>

#include <QByteArray>
#include <QCborMap>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "net/rosbridge/frame.h"

namespace mapwright::test {

/// A message and the frame that it lies in.
struct Sent {
  std::shared_ptr<const net::rosbridge::Frame> frame;
  net::rosbridge::Field msg;
};

inline Sent sent(const QByteArray& bytes, net::rosbridge::Frame::Wire wire) {
  auto frame = net::rosbridge::Frame::read(bytes, wire);
  const auto msg = frame->root();
  if (frame->fault() != net::rosbridge::Frame::Fault::None) qFatal("a test sends what is no frame");
  return {std::move(frame), msg};
}

inline Sent byJson(const QByteArray& text) { return sent(text, net::rosbridge::Frame::Wire::Text); }

inline Sent byCbor(const QCborMap& map) {
  return sent(QCborValue(map).toCbor(), net::rosbridge::Frame::Wire::Binary);
}

/// What stands in `text`, as a map to put typed arrays into.
inline QCborMap cborOf(const QByteArray& text) {
  const QJsonDocument document = QJsonDocument::fromJson(text);
  if (!document.isObject()) qFatal("a test writes what is no JSON");
  return QCborMap::fromJsonObject(document.object());
}

/// RFC 8746.
enum class TypedArray : quint64 { Int8 = 72, Float32 = 85, Float64 = 86 };
inline QCborValue typed(TypedArray type, const QByteArray& bytes) {
  return QCborValue(QCborTag(quint64(type)), bytes);
}

}  // namespace mapwright::test
