// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/shared_pixels.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace tp {
namespace {

constexpr std::size_t least_bytes = 1 << 20; ///< that are worth a descriptor

/// An allocator's part that is the same for both of these: the memory, of whatever kind, ends with the last
/// picture that lies in it.
template <typename Memory>
class PixelMemory : public cv::MatAllocator {
public:
    using cv::MatAllocator::allocate;

    bool allocate(cv::UMatData* data, cv::AccessFlag, cv::UMatUsageFlags) const override {
        return data != nullptr;
    }
    void deallocate(cv::UMatData* data) const override {
        if (data == nullptr)
            return;
        const std::unique_ptr<Memory> memory(static_cast<Memory*>(data->userdata));
        delete data;
    }

protected:
    cv::UMatData* data_of(Memory memory) const {
        auto* const data = new cv::UMatData(this);
        auto* const kept = new Memory(std::move(memory));
        data->data = data->origdata = static_cast<uchar*>(kept->data());
        data->size = kept->size();
        data->userdata = kept;
        return data;
    }
};

class SharedPixels final : public PixelMemory<SharedMemory> {
public:
    using PixelMemory<SharedMemory>::allocate;

    cv::UMatData* allocate(int dimensions, const int* sizes, int type, void* given, std::size_t* steps,
                           cv::AccessFlag access, cv::UMatUsageFlags usage) const override {
        std::size_t bytes = CV_ELEM_SIZE(type);
        for (int i = dimensions - 1; i >= 0; --i) {
            if (steps != nullptr)
                steps[i] = bytes;
            bytes *= static_cast<std::size_t>(sizes[i]);
        }
        if (given == nullptr && bytes >= least_bytes)
            if (std::optional<SharedMemory> memory = SharedMemory::make(bytes))
                return data_of(*std::move(memory));
        return cv::Mat::getStdAllocator()->allocate(dimensions, sizes, type, given, steps, access, usage);
    }
};

/// Of memory that is there already: nothing is allocated here.
class ViewedPixels final : public PixelMemory<Mapping> {
public:
    using PixelMemory<Mapping>::allocate;

    cv::UMatData* allocate(int dimensions, const int* sizes, int type, void* given, std::size_t* steps,
                           cv::AccessFlag access, cv::UMatUsageFlags usage) const override {
        return cv::Mat::getStdAllocator()->allocate(dimensions, sizes, type, given, steps, access, usage);
    }
    cv::Mat picture(cv::Size size, Mapping memory) const {
        cv::Mat picture(size, CV_8UC3, memory.data());
        picture.u = data_of(std::move(memory));
        picture.u->refcount = 1;
        return picture;
    }
};

// Pictures may outlive whatever else ends with the program.
const ViewedPixels& viewed_pixels() {
    static const ViewedPixels& allocator = *new ViewedPixels;
    return allocator;
}
SharedPixels& shared_pixels() {
    static SharedPixels& allocator = *new SharedPixels;
    return allocator;
}

/// The memory in which all of the picture lies, and nothing else; null where there is none.
const SharedMemory* memory_of(const cv::Mat& picture) {
    const cv::UMatData* const data = picture.u;
    const bool all = data != nullptr && data->currAllocator == &shared_pixels() && picture.isContinuous() &&
                     picture.data == data->data;
    return all ? static_cast<const SharedMemory*>(data->userdata) : nullptr;
}

} // namespace

void keep_pixels_in_shared_memory() { cv::Mat::setDefaultAllocator(&shared_pixels()); }

Descriptor handed_over(cv::Mat&& picture) {
    Descriptor memory;
    if (const SharedMemory* const own = memory_of(picture)) {
        memory = own->another();
    } else if (std::optional<SharedMemory> copy = SharedMemory::make(picture.total() * picture.elemSize())) {
        cv::Mat in_copy(picture.size(), picture.type(), copy->data());
        picture.copyTo(in_copy);
        memory = copy->another();
    }
    picture.release(); // nothing writes to it any more
    if (memory.ok() && !seal(memory))
        memory.reset();
    return memory;
}

cv::Mat pixels_in(const Descriptor& memory, cv::Size size) {
    if (size.width <= 0 || size.height <= 0)
        return {};
    const std::size_t bytes =
        std::size_t{3} * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    std::optional<Mapping> view = received(memory, bytes);
    return view ? viewed_pixels().picture(size, *std::move(view)) : cv::Mat();
}

} // namespace tp
