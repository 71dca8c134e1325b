// The icons of the window: one SVG each in resources/icons, coloured by the palette.
#pragma once

#include <QColor>
#include <QIcon>
#include <QImage>
#include <QPixmap>
#include <QString>

namespace mapwright::ui {

/// An icon from resources/icons/NAME.svg. It follows the application's palette: text colour, greyed if
/// disabled, accent if checked. Sharp at every size and device pixel ratio.
QIcon themedIcon(const QString& name);

/// A pixmap of that icon in another colour.
QPixmap iconPixmap(const QString& name, int size_px, double device_pixel_ratio, const QColor& color);

/// The same, painted into `rect`.
void paintIcon(QPainter* painter, const QRectF& rect, const QString& name, const QColor& color);

/// The same pixmap for equal pictures. Tables need it: the style keeps a scaled copy of each pixmap that a
/// cell gives it, and would keep one more at each painting.
QPixmap sharedPixmap(const QImage& picture);

/// Names of all icons that exist, for tests.
QStringList iconNames();

/// Makes the compiled-in resources reachable. Call once before the first icon (MainWindow and applyTheme do).
void loadResources();

}  // namespace mapwright::ui
