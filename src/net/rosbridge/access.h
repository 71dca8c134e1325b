// How the readers of this folder construct fields. Private to them.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include <simdjson.h>

#include "net/rosbridge/cbor_item.h"
#include "net/rosbridge/field.h"

namespace mapwright::net::rosbridge {

struct Access {
  static Field ofJson(const simdjson::dom::element& element) {
    Field field;
    if (!element.is_null()) {
      field.kind_ = Field::Kind::Json;
      field.raw_ = std::bit_cast<std::array<std::uint64_t, 2>>(element);
    }
    return field;
  }
  static simdjson::dom::element json(const Field& field) {
    return std::bit_cast<simdjson::dom::element>(field.raw_);
  }
  static Field ofNumber(const CborNumber& number) {
    Field field;
    if (const auto* whole = std::get_if<std::int64_t>(&number)) {
      field.kind_ = Field::Kind::Integer;
      field.raw_[0] = std::uint64_t(*whole);
      return field;
    }
    // Beyond int64: a real number that keeps its digits.
    const auto* natural = std::get_if<std::uint64_t>(&number);
    const double value = natural ? double(*natural) : std::get<double>(number);
    field.kind_ = std::isfinite(value) ? Field::Kind::Real : Field::Kind::NotFinite;
    field.raw_ = {std::bit_cast<std::uint64_t>(value), natural ? *natural : 0};
    return field;
  }
  /// The item at `at`, in bytes that lookThrough() has checked.
  static Field ofCbor(const std::uint8_t* at, const std::uint8_t* end) {
    const CborItem item = CborItem::at(at, end);
    if (item.type == CborItem::Type::Number) return ofNumber(item.number);
    Field field;
    if (item.type != CborItem::Type::Null) {
      field.kind_ = Field::Kind::Cbor;
      field.raw_ = {std::uint64_t(reinterpret_cast<std::uintptr_t>(at)),
                    std::uint64_t(reinterpret_cast<std::uintptr_t>(end))};
    }
    return field;
  }
  static const std::uint8_t* cborEnd(const Field& field) {
    return reinterpret_cast<const std::uint8_t*>(std::uintptr_t(field.raw_[1]));
  }
  static CborItem cbor(const Field& field) {
    return CborItem::at(reinterpret_cast<const std::uint8_t*>(std::uintptr_t(field.raw_[0])), cborEnd(field));
  }
  static bool isCbor(const Field& field) { return field.kind_ == Field::Kind::Cbor; }
  static bool isJson(const Field& field) { return field.kind_ == Field::Kind::Json; }
  static std::int64_t whole(const Field& field) { return std::int64_t(field.raw_[0]); }
  /// A whole number beyond int64 that fits uint64.
  static std::optional<std::uint64_t> natural(const Field& field) {
    std::uint64_t value = 0;
    if (field.kind_ == Field::Kind::Real && field.raw_[1] != 0) return field.raw_[1];
    if (isJson(field) && json(field).is_uint64() && json(field).get(value) == simdjson::SUCCESS) return value;
    return std::nullopt;
  }
  static double real(const Field& field) { return std::bit_cast<double>(field.raw_[0]); }

  /// The items of a list, until `visit` returns false. `Visit` is a template to avoid a function call for
  /// each number of a large JSON list.
  template <typename Visit>
  static void eachUntil(const Field& list, Visit visit) {
    if (isJson(list)) {
      simdjson::dom::array items;
      if (json(list).get(items)) return;
      for (const simdjson::dom::element item : items) {
        if (!visit(ofJson(item))) return;
      }
    } else if (isCbor(list)) {
      const CborItem item = cbor(list);
      const std::uint8_t* const end = cborEnd(list);
      if (item.type == CborItem::Type::Numbers) {
        for (std::size_t i = 0; i < item.numbers.count; ++i) {
          if (!visit(ofNumber(item.numbers.at(i)))) return;
        }
      } else if (item.type == CborItem::Type::List) {
        eachItem(item, end, [&](const std::uint8_t* at) { return visit(ofCbor(at, end)); });
      }
    }
  }
};

static_assert(sizeof(simdjson::dom::element) == 16);

}  // namespace mapwright::net::rosbridge
