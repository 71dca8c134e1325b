#include "ui/kit/icons.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "ui/kit/ui_colors.h"

// Must be outside of any namespace: the macro declares a function in the global one.
static void initResources() { Q_INIT_RESOURCE(mapwright); }

namespace mapwright::ui {

namespace {

QPixmap drawn(const QString& name, const QSize& size, double ratio, const QColor& color) {
  const QString key = QStringLiteral("mapwright/%1/%2x%3@%4/%5")
                          .arg(name)
                          .arg(size.width())
                          .arg(size.height())
                          .arg(ratio)
                          .arg(color.rgba(), 0, 16);
  QPixmap pixmap;
  if (size.isEmpty()) return pixmap;  // of a button that has no room yet
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  pixmap = QPixmap(size * ratio);
  pixmap.fill(Qt::transparent);
  pixmap.setDevicePixelRatio(ratio);
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (file.open(QIODevice::ReadOnly)) {
    QByteArray svg = file.readAll();
    svg.replace("currentColor", color.name(QColor::HexRgb).toLatin1());
    QSvgRenderer renderer(svg);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(color.alphaF());
    renderer.render(&painter, QRectF(QPointF(0, 0), QSizeF(size)));
  }
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

class SvgIconEngine : public QIconEngine {
 public:
  explicit SvgIconEngine(QString name) : name_(std::move(name)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const double ratio = painter->device()->devicePixelRatioF();
    painter->drawPixmap(rect, drawn(name_, rect.size(), ratio, color(mode, state)));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return drawn(name_, size, 1.0, color(mode, state));
  }
  QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal scale) override {
    QPixmap pixmap = drawn(name_, size / scale, scale, color(mode, state));
    return pixmap;
  }
  QIconEngine* clone() const override { return new SvgIconEngine(name_); }
  QString key() const override { return QStringLiteral("mapwright-svg"); }

 private:
  static QColor color(QIcon::Mode mode, QIcon::State state) {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
    if (state == QIcon::On) return appColors().accent_text;
    return palette.color(QPalette::Active, QPalette::ButtonText);
  }

  QString name_;
};

}  // namespace

QIcon themedIcon(const QString& name) { return QIcon(new SvgIconEngine(name)); }

QPixmap iconPixmap(const QString& name, int size_px, double device_pixel_ratio, const QColor& color) {
  return drawn(name, QSize(size_px, size_px), device_pixel_ratio, color);
}

void paintIcon(QPainter* painter, const QRectF& rect, const QString& name, const QColor& color) {
  const int size = qMax(1, qRound(qMin(rect.width(), rect.height())));
  const QPointF corner(qRound(rect.center().x() - size / 2.0), qRound(rect.center().y() - size / 2.0));
  painter->drawPixmap(corner, iconPixmap(name, size, painter->device()->devicePixelRatioF(), color));
}

QPixmap sharedPixmap(const QImage& picture) {
  QCryptographicHash hash(QCryptographicHash::Md5);
  for (int row = 0; row < picture.height(); ++row)
    hash.addData(QByteArrayView(picture.constScanLine(row), picture.width() * picture.depth() / 8));
  const QString key = QStringLiteral("picture/%1x%2@%3/%4/%5")
                          .arg(picture.width())
                          .arg(picture.height())
                          .arg(picture.devicePixelRatio())
                          .arg(picture.format())
                          .arg(QLatin1String(hash.result().toHex()));
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  pixmap = QPixmap::fromImage(picture);
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

QStringList iconNames() {
  QStringList names;
  for (const QString& file : QDir(QStringLiteral(":/icons")).entryList(QDir::Files, QDir::Name)) {
    names << QString(file).remove(QStringLiteral(".svg"));
  }
  return names;
}

void loadResources() { initResources(); }

}  // namespace mapwright::ui
