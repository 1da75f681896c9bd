#pragma once
#include <array>
#include <bit>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

#include "base/linalg.hpp"

namespace reye::output {

/// An archive of types instead of values: those that a `serialize` function names, in order and with all their members.
/// Two programs with the same description read each other's bytes; an exchange of two members of one type is not
/// detected.
class LayoutArchive {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (add(static_cast<const Values*>(&values)), ...);
  }
  const std::string& text() const { return text_; }

 private:
  template <class T>
  void of() {
    add(static_cast<const T*>(nullptr));
  }
  template <class T>
  void add(const std::vector<T>*) {
    text_ += "vector ";
    of<T>();
  }
  template <class T>
  void add(const std::set<T>*) {
    text_ += "set ";
    of<T>();
  }
  template <class T>
  void add(const std::optional<T>*) {
    text_ += "optional ";
    of<T>();
  }
  template <class T>
  void add(const std::shared_ptr<T>*) {
    text_ += "shared ";
    of<std::remove_const_t<T>>();
  }
  template <class T, std::size_t N>
  void add(const std::array<T, N>*) {
    text_ += "array " + std::to_string(N) + ' ';
    of<T>();
  }
  template <class K, class V>
  void add(const std::map<K, V>*) {
    text_ += "map ";
    of<K>();
    of<V>();
  }
  template <class A, class B>
  void add(const std::pair<A, B>*) {
    text_ += "pair ";
    of<A>();
    of<B>();
  }
  void add(const std::string*) { text_ += "string "; }
  template <class T, int R, int C, int O, int MR, int MC>
  void add(const Eigen::Matrix<T, R, C, O, MR, MC>*) {
    text_ += "matrix " + std::to_string(R) + ' ' + std::to_string(C) + ' ';
  }
  template <class T, int O, class Index>
  void add(const Eigen::SparseMatrix<T, O, Index>*) {
    text_ += "sparse " + std::to_string(O) + ' ' + std::to_string(sizeof(Index)) + ' ';
  }
  template <class T>
  void add(const T*) {
    text_ += typeid(T).name();
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      text_ += std::to_string(sizeof(T)) + ' ';
    } else {
      T value{};
      text_ += "{ ";
      if constexpr (requires { value.serialize(*this); })
        value.serialize(*this);
      else
        serialize(*this, value);
      text_ += "} ";
    }
  }

  std::string text_ = std::endian::native == std::endian::little ? "little " : "big ";
};

}  // namespace reye::output
