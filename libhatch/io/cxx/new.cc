/* The operators new and delete of commands that link packages in C++. Some destructors of these packages allocate, and
 * ending the process is all that C++ does when that fails: nlohmann::json, in tinygltf, makes a list of what it
 * destroys. So new has a reserve for when the system has no memory left. A failure is reported once, when half of the
 * reserve is used up; the rest is for the destructors that the exception calls. */
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace
{

const size_t reserve_bytes = size_t{4} << 20; /* takes no memory before it is used */
const size_t alignment = alignof(std::max_align_t);

alignas(std::max_align_t) unsigned char reserve[reserve_bytes];
std::atomic<size_t> used; /* bytes given out of the reserve; they do not come back */
std::atomic<bool> reported;

bool is_reserved(const void *block)
{
    uintptr_t at = reinterpret_cast<uintptr_t>(block), first = reinterpret_cast<uintptr_t>(reserve);
    return at >= first && at < first + reserve_bytes;
}

/* Returns memory from the reserve, or nullptr. */
void *take(size_t size)
{
    if (size > reserve_bytes)
        return nullptr;
    size_t rounded = (size + alignment - 1) / alignment * alignment;
    size_t at = used.load();
    do {
        size_t limit = reported.load() ? reserve_bytes : reserve_bytes / 2;
        if (rounded > limit - (at < limit ? at : limit))
            return nullptr;
    } while (!used.compare_exchange_weak(at, at + rounded));
    return reserve + at;
}

} // namespace

void *operator new(size_t size)
{
    void *block = std::malloc(size ? size : 1);
    if (!block)
        block = take(size ? size : 1);
    if (block)
        return block;
    reported.store(true);
    throw std::bad_alloc();
}

void operator delete(void *block) noexcept
{
    if (!is_reserved(block))
        std::free(block);
}

void operator delete(void *block, size_t) noexcept
{
    operator delete(block);
}
