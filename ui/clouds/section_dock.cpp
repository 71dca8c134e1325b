#include "ui/clouds/section_dock.h"

#include <QLabel>

#include "ui/clouds/cloud_text.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"

namespace mapwright::ui {

SectionDock::SectionDock(std::shared_ptr<work::Workers> workers, QWidget* parent)
    : QDockWidget(tr("Section"), parent),
      view_(new SectionView(std::move(workers), this)),
      width_(new DecimalBox(this)),
      told_(new PlainLabel(this)) {
  setObjectName(QStringLiteral("cloudSectionDock"));
  auto* const body = new QWidget(this);
  auto* const label = new QLabel(tr("&Width of the strip"), body);
  label->setBuddy(width_);
  width_->setRange(0.01, 1000);
  width_->setDecimals(2);
  width_->setSingleStep(0.1);
  width_->setSuffix(tr(" m"));
  width_->setValue(0.5);
  width_->setKeyboardTracking(false);
  width_->setAccessibleName(tr("Width of the strip"));
  auto* const fit = new QToolButton(body);
  fit->setIcon(themedIcon(QStringLiteral("fit")));
  fit->setAutoRaise(true);
  fit->setToolTip(tr("Show the whole section (F)"));
  fit->setAccessibleName(tr("The whole section"));
  told_->setSecondary(true);
  body->setLayout(columnOf({rowOf({label, width_, fit, {told_, 1}}), {view_, 1}}, 4, QMargins(6, 4, 6, 4)));
  setWidget(body);
  connect(width_, &QDoubleSpinBox::valueChanged, this, &SectionDock::widthChosen);
  connect(fit, &QToolButton::clicked, view_, &SectionView::fit);
  connect(view_, &SectionView::readingChanged, this, [this] {
    updateText();
    const auto& reading = view_->reading();
    Q_EMIT looksAt(reading ? std::optional(reading->at.x()) : std::nullopt);
  });
  updateText();
}

void SectionDock::showSection(std::shared_ptr<const clouds::Section> section, render::TilePainter painter) {
  view_->showSection(std::move(section), std::move(painter));
  updateText();
}

void SectionDock::updateText() {
  const auto& section = view_->section();
  if (!section) {
    told_->setText(tr("Choose Map > Section and drag a line over a cloud."));
  } else if (const auto& reading = view_->reading()) {
    told_->setText(sectionPlaceText(reading->at, reading->nearest));
  } else {
    told_->setText(sectionText(*section));
  }
}

}  // namespace mapwright::ui

#include "moc_section_dock.cpp"
