import js from '@eslint/js';
import tseslint from 'typescript-eslint';

export default tseslint.config(
  { ignores: ['dist/', 'node_modules/'] },
  js.configs.recommended,
  ...tseslint.configs.strictTypeChecked,
  {
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    rules: {
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
      '@typescript-eslint/no-confusing-void-expression': ['error', { ignoreArrowShorthand: true }],
      eqeqeq: 'error',
    },
  },
  {
    files: ['**/*.js', '**/*.mjs'],
    ...tseslint.configs.disableTypeChecked,
    languageOptions: {
      parserOptions: { projectService: false },
      globals: { process: 'readonly', Buffer: 'readonly', console: 'readonly', setTimeout: 'readonly', URL: 'readonly' },
    },
  },
  // model and geo are pure: they know neither OpenLayers nor the document.
  {
    files: ['src/model/**/*.ts', 'src/geo/**/*.ts'],
    rules: { 'no-restricted-imports': ['error', { patterns: ['ol', 'ol/*', '**/map/*', '**/ui/*'] }] },
  },
  { files: ['src/ui/**/*.tsx'], rules: { 'no-restricted-imports': ['error', { patterns: ['ol', 'ol/*'] }] } },
  { files: ['src/map/**/*.ts'], rules: { 'no-restricted-globals': ['error', 'fetch'] } },
);
