// Shows which colour of a cloud means which value.
#pragma once

#include <optional>

#include <QWidget>

#include "ui/scene/clouds_layer.h"

namespace mapwright::ui {

/// A bar of the colours with the values at its ends and in its middle. Hidden without a scale.
class ColorScale : public QWidget {
  Q_OBJECT
 public:
  explicit ColorScale(QWidget* parent = nullptr);
  void setScale(const std::optional<scene::CloudScale>& scale);
  /// "0.00 m", "1.25 m", "2.50 m"; empty without a scale.
  QStringList values() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<scene::CloudScale> scale_;
};

}  // namespace mapwright::ui
