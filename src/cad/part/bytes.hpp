#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/issue.hpp"
#include "base/space.hpp"

/// Values as bytes through a pipe, and back. The members of a struct are passed by a function of its namespace that
/// names them once for both ways: `template <class Archive> void pass(Archive& archive, Struct& value)`.
namespace reye::cad {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Appends values to `bytes`.
class Writer {
 public:
  template <Plain T>
  void operator()(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <int n>
  void operator()(const Eigen::Matrix<double, n, 1>& p) {
    for (double x : p) (*this)(x);
  }
  template <class T, std::size_t N>
  void operator()(const std::array<T, N>& values) {
    for (const T& value : values) (*this)(value);
  }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint64_t>(text.size()));
    bytes += text;
  }
  template <class List>
  requires requires(const List& list) {
    list.begin();
    list.size();
  }
  void operator()(const List& list) {
    (*this)(static_cast<std::uint64_t>(list.size()));
    for (const auto& value : list) (*this)(value);
  }
  template <class A, class B>
  void operator()(const std::pair<A, B>& pair) {
    (*this)(pair.first);
    (*this)(pair.second);
  }
  template <class T>
  requires requires(Writer& writer, T& value) { pass(writer, value); }
  void operator()(const T& value) {
    pass(*this, const_cast<T&>(value));  // the order of members is written once, for both ways
  }

  std::string bytes;
};

/// Takes values from bytes that are not trusted. Throws std::runtime_error where they end early or a coordinate is not
/// finite.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <Plain T>
  void operator()(T& value) {
    if (rest_.size() < sizeof value) throw std::runtime_error("ends early");
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
  }
  void operator()(bool& value) {
    char byte = 0;
    (*this)(byte);
    value = byte != 0;
  }
  template <int n>
  void operator()(Eigen::Matrix<double, n, 1>& p) {
    for (double& x : p) (*this)(x);
    if (!p.allFinite()) throw std::runtime_error("holds a coordinate that is not a finite number");
  }
  template <class T, std::size_t N>
  void operator()(std::array<T, N>& values) {
    for (T& value : values) (*this)(value);
  }
  void operator()(std::string& text) {
    const std::size_t n = count();
    text = rest_.substr(0, n);
    rest_.remove_prefix(n);
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    for (std::size_t n = count(); n > 0; --n) (*this)(list.emplace_back());
  }
  void operator()(std::vector<bool>& list) {
    for (std::size_t n = count(); n > 0; --n) {
      bool value = false;
      (*this)(value);
      list.push_back(value);
    }
  }
  template <class T>
  void operator()(std::set<T>& list) {
    for (std::size_t n = count(); n > 0; --n) {
      T value;
      (*this)(value);
      list.insert(std::move(value));
    }
  }
  template <class K, class V>
  void operator()(std::map<K, V>& list) {
    for (std::size_t n = count(); n > 0; --n) {
      std::pair<K, V> entry;
      (*this)(entry);
      list.insert(std::move(entry));
    }
  }
  template <class A, class B>
  void operator()(std::pair<A, B>& pair) {
    (*this)(pair.first);
    (*this)(pair.second);
  }
  template <class T>
  requires requires(Reader& reader, T& value) { pass(reader, value); }
  void operator()(T& value) { pass(*this, value); }

  bool at_end() const { return rest_.empty(); }

 private:
  /// Reads a count, which cannot exceed the bytes left, since each element takes at least one byte.
  std::size_t count() {
    std::uint64_t n = 0;
    (*this)(n);
    if (n > rest_.size()) throw std::runtime_error("ends early");
    return static_cast<std::size_t>(n);
  }
  std::string_view rest_;
};

/// A value as bytes.
template <class T>
std::string written(const T& value) {
  Writer writer;
  writer(value);
  return std::move(writer.bytes);
}

/// The value that the bytes are, all of them. Throws std::runtime_error where they end early or late.
template <class T>
T read_whole(std::string_view bytes) {
  T value;
  Reader reader(bytes);
  reader(value);
  if (!reader.at_end()) throw std::runtime_error("continues behind its end");
  return value;
}

template <class Archive>
void pass(Archive& archive, base::Issue& issue) {
  archive(issue.key), archive(issue.value), archive(issue.rule);
}

}  // namespace reye::cad
