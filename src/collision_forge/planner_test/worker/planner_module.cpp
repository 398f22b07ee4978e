#include "collision_forge/planner_test/worker/planner_module.h"

#include <torch/cuda.h>
#include <torch/utils.h>
#include <torch/version.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace forge {
namespace {

constexpr std::uint64_t kSeed = 0;  // of the file's random numbers

torch::Device deviceOf(const std::string& name) {
  const bool has_cuda = torch::cuda::is_available();
  if (name == "cuda" && !has_cuda) {
    throw std::runtime_error("device = cuda: this libtorch finds no CUDA device; use cpu or auto");
  }
  return name == "cpu" || !has_cuda ? torch::Device(torch::kCPU) : torch::Device(torch::kCUDA);
}

/// Returns libtorch's error in one line: the last line of a traceback, else the first line.
std::string complaint(const std::exception& error) {
  std::istringstream text(error.what());
  const bool is_traced = text.str().find("Traceback of TorchScript") != std::string::npos;
  std::string line;
  std::string last_line;
  while (std::getline(text, line) && (is_traced || last_line.empty())) {
    if (line.find_first_not_of(' ') != std::string::npos) last_line = line;
  }
  return last_line;
}

torch::jit::Module loadModule(const std::string& file, const torch::Device& device) {
  if (!std::ifstream(file, std::ios::binary)) throw std::runtime_error("cannot be read");
  try {
    torch::jit::Module module = torch::jit::load(file, device);
    module.eval();
    return module;
  } catch (const std::exception& error) {
    throw std::runtime_error(
        "is not a TorchScript file that libtorch " TORCH_VERSION " can load: " + complaint(error));
  }
}

/// Throws unless forward() has the required inputs by name and in order.
void checkInputs(const torch::jit::Module& module, const ModelContract& contract) {
  const auto forward = module.find_method("forward");
  if (!forward) throw std::runtime_error("has no forward()");
  const auto& arguments = forward->function().getSchema().arguments();  // the first is self
  for (std::size_t i = 0; i < contract.inputs.size(); ++i) {
    const std::string name = contract.inputs[i].name;
    if (arguments.size() <= i + 1) throw std::runtime_error("forward() has no input " + name);
    const c10::Argument& argument = arguments[i + 1];
    if (argument.name() != name) {
      throw std::runtime_error("input " + std::to_string(i + 1) + " of forward() is " +
                               argument.name() + ", not " + name);
    }
    if (!c10::TensorType::get()->isSubtypeOf(*argument.type())) {
      throw std::runtime_error("the input " + name + " of forward() is of type " +
                               argument.type()->str() + ", not Tensor");
    }
  }
  const std::size_t expected = contract.inputs.size() + 1;
  if (arguments.size() > expected && !arguments[expected].default_value()) {
    throw std::runtime_error("forward() has an unknown input: " + arguments[expected].name());
  }
}

std::vector<std::int64_t> sizesOf(const ContractTensor& tensor) {
  return {tensor.sizes.begin(), tensor.sizes.begin() + static_cast<long>(tensor.dimensions)};
}

std::string text(const c10::IntArrayRef& sizes) {
  std::ostringstream stream;
  stream << sizes;
  return stream.str();
}

std::vector<c10::IValue> tensorsOf(const std::vector<float>& numbers, const ModelContract& contract,
                                   const torch::Device& device) {
  std::vector<c10::IValue> tensors;
  const float* next = numbers.data();
  for (const ContractTensor& input : contract.inputs) {
    torch::Tensor tensor = torch::empty(sizesOf(input), torch::kFloat32);
    std::memcpy(tensor.data_ptr<float>(), next, input.count() * sizeof(float));
    tensors.emplace_back(tensor.to(device));
    next += input.count();
  }
  return tensors;
}

/// Throws unless type and shape of the tensor match.
torch::Tensor checkedOutput(const c10::IValue& value, const ContractTensor& output) {
  const std::string name = output.name;
  if (!value.isTensor()) {
    throw std::runtime_error(name + " is of type " + value.tagKind() + ", not Tensor");
  }
  const torch::Tensor& tensor = value.toTensor();
  const std::vector<std::int64_t> sizes = sizesOf(output);
  if (tensor.sizes() != c10::IntArrayRef(sizes)) {
    throw std::runtime_error(name + " has the shape " + text(tensor.sizes()) + ", not " +
                             text(sizes));
  }
  if (tensor.scalar_type() != torch::kFloat32) {
    throw std::runtime_error(name + " is of " + c10::toString(tensor.scalar_type()) +
                             ", not Float (32 bits)");
  }
  return tensor.to(torch::kCPU).contiguous();
}

}  // namespace

PlannerModule::PlannerModule(const std::string& file, const std::string& device,
                             const ModelContract& contract)
    : contract_(contract), device_(deviceOf(device)) {
  torch::set_num_threads(1);
  torch::jit::setGraphExecutorOptimize(false);
  torch::globalContext().setDeterministicAlgorithms(true, true);
  loaded_ = loadModule(file, device_);
  checkInputs(loaded_, contract_);
  tryOut();
}

void PlannerModule::begin() {
  torch::manual_seed(kSeed);
  module_ = loaded_.deepcopy();
}

std::vector<float> PlannerModule::plan(const std::vector<float>& inputs) {
  const torch::NoGradGuard no_gradients;
  c10::IValue output;
  try {
    output = module_.forward(tensorsOf(inputs, contract_, device_));
  } catch (const std::exception& error) {
    throw std::runtime_error("forward() throws: " + complaint(error));
  }
  const torch::Tensor tensor = checkedOutput(output, contract_.output);
  const float* numbers = tensor.data_ptr<float>();
  return {numbers, numbers + tensor.numel()};
}

void PlannerModule::tryOut() {
  const auto isFinite = [](float number) { return std::isfinite(number); };
  for (const auto& [what, number] : {std::pair("no agents or lanes around the ego", 0.0f),
                                     std::pair("all inputs filled", 1.0f)}) {
    begin();
    try {
      const std::vector<float> poses = plan(std::vector<float>(contract_.numbers(), number));
      if (!std::all_of(poses.begin(), poses.end(), isFinite)) {
        throw std::runtime_error(std::string(contract_.output.name) +
                                 " has numbers that are not finite");
      }
    } catch (const std::exception& error) {
      throw std::runtime_error(std::string("tried with ") + what + ": " + error.what());
    }
  }
}

}  // namespace forge
