// Frames as a server would write them, made with Qt's writers and not with ours.
#pragma once

#include <cmath>

#include <QBuffer>
#include <QByteArray>
#include <QCborStreamWriter>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>

#include "net/rosbridge/frame.h"

namespace mapwright::net::rosbridge::testing {

inline std::shared_ptr<const Frame> json(const QByteArray& text) {
  return Frame::read(text, Frame::Wire::Text);
}
inline std::shared_ptr<const Frame> cbor(const QByteArray& bytes) {
  return Frame::read(bytes, Frame::Wire::Binary);
}

inline QByteArray written(const std::function<void(QCborStreamWriter&)>& write) {
  QByteArray bytes;
  QCborStreamWriter writer(&bytes);
  write(writer);
  return bytes;
}

/// {"a": <tag>(bytes)}
inline QByteArray typedArray(quint64 tag, const QByteArray& bytes) {
  return written([&](QCborStreamWriter& writer) {
    writer.startMap(1);
    writer.append(QStringLiteral("a"));
    writer.append(QCborTag(tag));
    writer.append(bytes);
    writer.endMap();
  });
}

/// As rosbridge makes it: nearly square, filled up with newlines.
inline QByteArray pictureOf(QByteArray text) {
  const int width = std::max(1, int(std::floor(std::sqrt(double(text.size()) / 3.0))));
  const int height = int(std::ceil(double(text.size()) / 3.0 / width));
  text.append(QByteArray(qsizetype(width) * height * 3 - text.size(), '\n'));
  const QImage image(reinterpret_cast<const uchar*>(text.constData()), width, height, width * 3,
                     QImage::Format_RGB888);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return png;
}

inline QByteArray pictureFrame(const QByteArray& text) {
  return R"({"op":"png","data":")" + pictureOf(text).toBase64() + R"("})";
}

/// {"op":"fragment","id":…,"num":…,"total":…,"data":…}
inline QByteArray pieceFrame(const QJsonValue& id, int number, double total, const QByteArray& data) {
  return QJsonDocument(QJsonObject{{QStringLiteral("op"), QStringLiteral("fragment")},
                                   {QStringLiteral("id"), id},
                                   {QStringLiteral("num"), number},
                                   {QStringLiteral("total"), total},
                                   {QStringLiteral("data"), QString::fromUtf8(data)}})
      .toJson(QJsonDocument::Compact);
}

}  // namespace mapwright::net::rosbridge::testing
