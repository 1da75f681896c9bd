#pragma once
#include <cereal/archives/binary.hpp>
#include <cereal/types/memory.hpp>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <vector>

namespace reye::output {

/// cereal's binary archive, read from untrusted bytes: it refuses sizes beyond the remaining bytes, truth values other
/// than 0 and 1, and pointers to an object of another type. Throws cereal::Exception.
class BoundedInput : public cereal::InputArchive<BoundedInput, cereal::AllowEmptyClassElision> {
 public:
  explicit BoundedInput(std::string_view bytes) : InputArchive(this), left_(bytes) {}

  void loadBinary(void* data, std::size_t size) {
    need(size);
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }

  /// Throws unless so many values, each of at least so many bytes, can still follow.
  void need(std::uint64_t count, std::uint64_t bytes_each = 1) const {
    if (count > left_.size() / bytes_each) throw cereal::Exception("a size goes beyond the end");
  }

  /// Throws unless everything has been read.
  void end() const {
    if (!left_.empty()) throw cereal::Exception("it continues behind the end");
  }

  /// The objects of an archive's pointers, by their numbers from 1.
  struct Shared {
    std::shared_ptr<void> object;
    std::type_index type;
  };
  std::vector<Shared> shared;

 private:
  std::string_view left_;
};

template <class T>
requires std::is_arithmetic_v<T>
void CEREAL_LOAD_FUNCTION_NAME(BoundedInput& archive, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    unsigned char byte = 0;
    archive.loadBinary(&byte, 1);
    if (byte > 1) throw cereal::Exception("a truth value is neither true nor false");
    value = byte == 1;
  } else {
    archive.loadBinary(&value, sizeof value);
  }
}

template <class T>
void CEREAL_SERIALIZE_FUNCTION_NAME(BoundedInput& archive, cereal::NameValuePair<T>& pair) {
  archive(pair.value);
}

template <class T>
void CEREAL_SERIALIZE_FUNCTION_NAME(BoundedInput& archive, cereal::SizeTag<T>& tag) {
  archive(tag.size);
  archive.need(tag.size);
}

template <class T>
void CEREAL_LOAD_FUNCTION_NAME(BoundedInput& archive, cereal::BinaryData<T>& data) {
  archive.loadBinary(data.data, static_cast<std::size_t>(data.size));
}

/// Reads a pointer as cereal does: number 0 for null; the highest bit says that the object follows, else it has been
/// read before.
template <class T>
void CEREAL_LOAD_FUNCTION_NAME(BoundedInput& archive, cereal::memory_detail::PtrWrapper<std::shared_ptr<T>&>& wrapper) {
  std::uint32_t number = 0;
  archive(number);
  wrapper.ptr.reset();
  if (number == 0) return;
  if (number & cereal::detail::msb_32bit) {
    if ((number & ~cereal::detail::msb_32bit) != archive.shared.size() + 1)
      throw cereal::Exception("a pointer has a wrong number");
    auto object = std::make_shared<std::remove_const_t<T>>();
    archive.shared.push_back({object, typeid(T)});
    archive(*object);
    wrapper.ptr = std::move(object);
    return;
  }
  if (number > archive.shared.size() || archive.shared[number - 1].type != typeid(T))
    throw cereal::Exception("a pointer points to an object of another kind");
  wrapper.ptr = std::static_pointer_cast<std::remove_const_t<T>>(archive.shared[number - 1].object);
}

}  // namespace reye::output

CEREAL_REGISTER_ARCHIVE(reye::output::BoundedInput)

namespace cereal::traits::detail {

/// Marks it as the reader of cereal's binary archive.
template <>
struct get_output_from_input<reye::output::BoundedInput> {
  using type = BinaryOutputArchive;
};

}  // namespace cereal::traits::detail
