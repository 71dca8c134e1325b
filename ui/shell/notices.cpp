#include "ui/shell/notices.h"

#include "ui/view/notice_bar.h"

namespace mapwright::ui {

Notices::Notices(NoticeBar* bar, QObject* parent) : QObject(parent), bar_(bar) {
  connect(bar_, &NoticeBar::offerTaken, this, [this] {
    const Notice* const notice = first();
    if (!notice || !notice->accept) return;
    const auto accept = notice->accept;  // the call may delete the notice
    accept();
  });
  connect(bar_, &NoticeBar::closed, this, [this] {
    dismissed_.insert(bar_->sentence());
    show();
  });
}

void Notices::set(NoticeRank rank, Notice notice) {
  wanted_[rank] = std::move(notice);
  show();
}

const Notice* Notices::first() const {
  for (const auto& [rank, notice] : wanted_) {
    if (notice.sentence.isEmpty() || (notice.closable && dismissed_.contains(notice.sentence))) continue;
    return &notice;
  }
  return nullptr;
}

void Notices::show() {
  const Notice* const notice = first();
  if (!notice) return bar_->setNotice(Mark::None, {}, {});
  bar_->setNotice(notice->mark, notice->sentence, notice->offer, notice->closable);
}

}  // namespace mapwright::ui

#include "moc_notices.cpp"
