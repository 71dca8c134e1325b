// The order of names, as people count: "Rack 2" stands before "Rack 10".
#pragma once

#include <cstddef>
#include <unordered_map>

#include <QCollator>
#include <QLocale>
#include <QString>

namespace mapwright::ui {

inline QCollator nameOrder() {
  QCollator order;
  // The C locale always compares bytes.
  if (order.locale().language() == QLocale::C)
    order.setLocale(QLocale(QLocale::English, QLocale::UnitedStates));
  order.setNumericMode(true);
  order.setCaseSensitivity(Qt::CaseInsensitive);
  return order;
}

/// For lists that are sorted again and again: what was compared once is known.
class NameOrder {
 public:
  bool isLess(const QString& a, const QString& b) const { return key(a).compare(key(b)) < 0; }
  /// To be called now and then: names come and go.
  void forgetMany() {
    if (keys_.size() > kMost) keys_.clear();
  }

 private:
  static constexpr std::size_t kMost = 200'000;
  const QCollatorSortKey& key(const QString& name) const {
    const auto known = keys_.find(name);
    return known != keys_.end() ? known->second : keys_.emplace(name, order_.sortKey(name)).first->second;
  }

  QCollator order_ = nameOrder();
  mutable std::unordered_map<QString, QCollatorSortKey> keys_;
};

}  // namespace mapwright::ui
